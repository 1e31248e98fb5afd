"""What a migration from Gazebo Classic to gz makes of worlds and models in SDF."""

from __future__ import annotations

import pytest
from classic_packages import DRIVE, base, migrated
from folder import Folder

BUOY = """\
<sdf version="1.6">
  <model name="buoy">
    <link name="hull">
      <sensor name="motion" type="imu"/>
    </link>
  </model>
</sdf>
"""
MODEL = {"model.config": "<model/>\n", "model.sdf": BUOY}
IMU = 'filename="gz-sim-imu-system"'


def world(inside: str) -> str:
    """A world with some elements."""
    return f"""\
<?xml version="1.0"?>
<sdf version="1.6">
  <world name="yard">
{inside}  </world>
</sdf>
"""


def included(uri: str) -> str:
    """A model of a world."""
    return f"    <include>\n      <uri>{uri}</uri>\n    </include>\n"


def of_world(folder: Folder, inside: str, files: dict[str, str] | None = None, *words: str) -> str:
    """A world after its migration, in a package with a robot for Gazebo Classic."""
    files = {"urdf/base.xacro": base(DRIVE), "worlds/yard.world": world(inside), **(files or {})}
    return migrated(folder, files, *words)["worlds/yard.world"]


@pytest.mark.parametrize(("name", "address"), [("sun", "Sun"), ("ground_plane", "Ground Plane")])
def test_the_models_of_every_world_come_from_fuel(folder: Folder, name: str, address: str) -> None:
    after = of_world(folder, included(f"model://{name}"))
    assert after == world(included(f"https://fuel.gazebosim.org/1.0/OpenRobotics/models/{address}"))


def test_a_model_of_the_packages_keeps_its_name(folder: Folder) -> None:
    text = included("model://shelf")
    assert of_world(folder, text, {"models/shelf/model.config": "<model/>\n"}) == world(text)


def test_a_mesh_in_the_folder_of_models_is_found_by_its_name(folder: Folder) -> None:
    text = included("model://bowl.dae")
    assert of_world(folder, text, {"models/bowl.dae": "<COLLADA/>\n"}) == world(text)


def test_an_unknown_model_is_left_to_a_person_once(folder: Folder) -> None:
    after = of_world(folder, included("model://cafe") * 2)
    what = "model 'cafe' is not in these packages: add it to one, or name its address on Fuel"
    first = included("model://cafe").replace("      <uri", f"      <!-- TODO(urdfctl): {what} -->\n      <uri")
    assert after == world(first + included("model://cafe"))


def test_a_plugin_of_a_world_that_gz_needs_not_is_removed(folder: Folder) -> None:
    text = '    <plugin name="factory" filename="libgazebo_ros_factory.so"/>\n'
    assert of_world(folder, text) == world("")


def test_another_plugin_of_a_world_becomes_a_comment_so_that_gz_loads_its_default_systems(folder: Folder) -> None:
    rate = "      <update_rate>1</update_rate>\n"
    after = of_world(folder, f'    <plugin name="state" filename="libgazebo_ros_state.so">\n{rate}    </plugin>\n')
    assert after == world(
        "    <!-- TODO(urdfctl): plugin 'gazebo_ros_state' is kept as a comment: no system of gz replaces it -->\n"
        '    <!-- <plugin name="state" filename="libgazebo_ros_state.so">\n'
        f"{rate}    </plugin> -->\n"
    )


def test_a_world_stays_for_gazebo_classic(folder: Folder) -> None:
    text = included("model://sun")
    assert of_world(folder, text, None, "--to", "humble") == world(text)


def material(inside: str) -> str:
    """A model with a material."""
    return f"""\
    <model name="box">
      <link name="box">
        <visual name="box">
          <material>
{inside}          </material>
        </visual>
      </link>
    </model>
"""


def test_a_script_of_a_material_becomes_its_colour(folder: Folder) -> None:
    script = """\
            <script>
              <uri>file://media/materials/scripts/gazebo.material</uri>
              <name>Gazebo/Red</name>
            </script>
"""
    colours = "            <ambient>1 0 0 1</ambient>\n            <diffuse>1 0 0 1</diffuse>\n"
    assert of_world(folder, material(script)) == world(material(colours))


def test_a_script_beside_colours_is_removed(folder: Folder) -> None:
    script = "            <script><name>Mine/Brick</name></script>\n"
    colours = "            <ambient>1 0 0 1</ambient>\n            <diffuse>1 0 0 1</diffuse>\n"
    assert of_world(folder, material(script + colours)) == world(material(colours))


def test_the_script_of_an_unknown_material_is_left_to_a_person(folder: Folder) -> None:
    after = of_world(folder, material("            <script><name>Mine/Brick</name></script>\n"))
    assert "<!-- TODO(urdfctl): gz does not read the script of material 'Mine/Brick'" in after


def test_a_sensor_in_sdf_loses_its_plugin_and_keeps_its_topic(folder: Folder) -> None:
    sensor = """\
    <model name="pole">
      <link name="pole">
        <sensor name="scan" type="ray">
          <plugin name="scan" filename="libgazebo_ros_ray_sensor.so">
            <ros><remapping>~/out:=pole/scan</remapping></ros>
            <frame_name>pole</frame_name>
          </plugin>
        </sensor>
      </link>
    </model>
"""
    after = of_world(folder, sensor)
    assert '<sensor name="scan" type="gpu_lidar">' in after
    assert "<topic>pole/scan</topic>" in after
    assert "<gz_frame_id>pole</gz_frame_id>" in after
    assert "gazebo_ros" not in after


@pytest.mark.parametrize(("config", "count"), [("<model/>\n", 2), ("", 1)])
def test_each_version_of_a_model_loads_the_systems_of_its_sensors(folder: Folder, config: str, count: int) -> None:
    """The simulator reads one of the files that model.config names."""
    files = {"models/buoy/model.sdf": BUOY, "models/buoy/model-1_4.sdf": BUOY, "urdf/base.xacro": base(DRIVE)}
    files |= {"models/buoy/model.config": config} if config else {}
    after = migrated(folder, files)
    assert "".join(after[name] for name in files).count('filename="gz-sim-imu-system"') == count


@pytest.mark.parametrize(
    ("worlds", "loading"),
    [
        ({"one": ("red",), "two": ("blue",)}, ["blue", "red"]),
        ({"one": ("red", "blue"), "two": ("blue",)}, ["blue"]),
        ({"one": ("red", "blue")}, ["blue"]),
        ({}, ["blue", "red"]),
    ],
)
def test_one_model_of_each_world_loads_the_systems_of_its_sensors(
    folder: Folder, worlds: dict[str, tuple[str, ...]], loading: list[str]
) -> None:
    """Models that no world includes are spawned, one or the other."""
    files = {f"models/{name}/{file}": text for name in ("blue", "red") for file, text in MODEL.items()}
    for name, models in worlds.items():
        files[f"worlds/{name}.world"] = world("".join(included(f"model://{one}") for one in models))
    after = migrated(folder, {"urdf/base.xacro": base(DRIVE), **files})
    assert [one for one in ("blue", "red") if IMU in after[f"models/{one}/model.sdf"]] == loading


def test_no_model_loads_a_system_twice_in_a_world(folder: Folder) -> None:
    """Two worlds need it for one model each, and a third has both models."""
    files = {f"models/{name}/{file}": text for name in ("blue", "red") for file, text in MODEL.items()}
    for name in ("blue", "red", "blue red"):
        files[f"worlds/{name.replace(' ', '_')}.world"] = world(
            "".join(included(f"model://{one}") for one in name.split())
        )
    after = migrated(folder, {"urdf/base.xacro": base(DRIVE), **files})
    assert [one for one in ("blue", "red") if IMU in after[f"models/{one}/model.sdf"]] == ["blue"]
    assert "TODO(urdfctl): gz-sim-imu-system: no model of this world can load it alone" in after["worlds/red.world"]


def test_a_model_in_a_world_loads_the_systems_of_its_sensors(folder: Folder) -> None:
    model = "".join(f"  {line}\n" for line in BUOY.splitlines()[1:-1])
    assert of_world(folder, model).count(IMU) == 1


def test_a_version_for_sdf_1_2_is_one_of_its_model(folder: Folder) -> None:
    """It has <gazebo> in place of <sdf>, and is not the only version that loads the systems."""
    old = BUOY.replace('<sdf version="1.6">', '<gazebo version="1.2">').replace("</sdf>", "</gazebo>")
    files = {f"models/buoy/{name}": text for name, text in {**MODEL, "model-1_2.sdf": old}.items()}
    after = migrated(folder, {"urdf/base.xacro": base(DRIVE), **files})
    assert IMU in after["models/buoy/model.sdf"]


@pytest.mark.parametrize(
    "library", ["ignition-gazebo-imu-system", "libignition-gazebo6-imu-system.so", "gz-sim-imu-system"]
)
def test_a_world_that_loads_a_system_by_any_name_is_not_given_it_again(folder: Folder, library: str) -> None:
    plugin = f'    <plugin filename="{library}" name="ignition::gazebo::systems::Imu"/>\n'
    model = "".join(f"  {line}\n" for line in BUOY.splitlines()[1:-1])
    assert of_world(folder, plugin + model).count("imu-system") == 1
