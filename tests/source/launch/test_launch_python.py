"""Launch files in Python are read for what they surely build; nothing of them is run, and guessed is nothing."""

from __future__ import annotations

from collections.abc import Mapping
from textwrap import dedent

import pytest
from hostile.launch import ENDLESS

from urdfctl.model.launch import Launch, Spawn
from urdfctl.model.launch.ros2 import Ros2Sources, launch_of_ros2
from urdfctl.source.launch.python import Surroundings, read_python
from urdfctl.source.launch.terms import Term
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import ProblemKind
from urdfctl.source.span import Place, SourceText

IMPORTS = """\
import os
import xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import *
from launch_ros.actions import Node, PushRosNamespace
from launch_ros.parameter_descriptions import ParameterValue, ParameterFile
from launch_ros.substitutions import FindPackageShare
"""


def launch(body: str, arguments: Mapping[str, str] | None = None, **files: str) -> Launch:
    """The facts of a launch file whose function has a body; others lie at /p/<name>.launch.py, p is the package."""
    texts = {f"/p/{name}.launch.py": IMPORTS + dedent(text) for name, text in files.items()}
    texts["/p/main.launch.py"] = IMPORTS + (body if "def generate" in body else function(body))

    def find(name: str, _: Place) -> str | None:
        return "/p" if name == "p" else None

    def read(path: str) -> Term | None:
        if path not in texts:
            return None
        script = read_python(SourceText(path, texts[path].encode()), Surroundings(find, {"HERE": "x"}))
        assert {problem.kind for problem in script.problems} <= {ProblemKind.ARGUMENT_COMPARED}, script.problems
        return script.term

    sources = Ros2Sources(read, lambda path: (path, True), find, {"HERE": "x"})
    found = launch_of_ros2("/p/main.launch.py", arguments or {}, sources)
    assert found is not None
    return found


def function(body: str) -> str:
    """A file whose one function has a body; an expression alone is the list of actions."""
    body = dedent(body).strip()
    if "return" not in body and "ld" not in body.split():
        body = f"return LaunchDescription([{body}])"
    return "def generate_launch_description():\n" + "".join(f"    {line}\n" for line in body.splitlines())


def names(found: Launch) -> list[str]:
    return [name for spawn in found.spawns for name, _ in spawn.names]


def spawn(found: Launch) -> Spawn:
    (only,) = found.spawns
    return only


def spawner(*words: str, more: str = "") -> str:
    return f"Node(package='controller_manager', executable='spawner', arguments={list(words)!r}{more})"


IDIOMS = {
    "a list of words": (spawner("arm", "-c", "/controller_manager"), ["arm"]),
    "several names": (spawner("jsb", "arm"), ["jsb", "arm"]),
    "an option by its beginning": (spawner("jsb", "--controller-manager-time", "60", "--switch-t=9"), ["jsb"]),
    "a loop over names": (
        """
        nodes = []
        for name in ['jsb', 'arm']:
            nodes.append(Node(package='controller_manager', executable='spawner', arguments=[name]))
        return LaunchDescription(nodes)
        """,
        ["jsb", "arm"],
    ),
    "a list made by a comprehension": (
        """
        return LaunchDescription([
            Node(package='controller_manager', executable='spawner', arguments=[name, '-c', f'/{ns}/manager'])
            for ns, name in (('a', 'jsb'), ('a', 'arm')) if name != 'none'])
        """,
        ["jsb", "arm"],
    ),
    "a function of the file": (
        """
        def make(name, *, stopped=False):
            return Node(package='controller_manager', executable='spawner',
                        arguments=[name] + (['--inactive'] if stopped else []))
        return LaunchDescription([make('jsb'), make('arm', stopped=True)])
        """,
        ["jsb", "arm"],
    ),
    "a helper whose condition is None": (
        """
        def make(name, condition=None):
            return Node(package='controller_manager', executable='spawner', arguments=[name], condition=condition)
        return LaunchDescription([make('jsb'), make('arm', UnlessCondition('false'))])
        """,
        ["jsb", "arm"],
    ),
    "a variable of the environment with a default": (
        """
        names = [os.getenv('NAME', default='jsb'), os.getenv('NAME', 'arm'), os.environ.get('NAME', default='hand')]
        return LaunchDescription([Node(package='controller_manager', executable='spawner', arguments=names)])
        """,
        ["jsb", "arm", "hand"],
    ),
    "a description that actions are added to": (
        """
        ld = LaunchDescription()
        jsb = Node(package='controller_manager', executable='spawner', arguments=['jsb'])
        ld.add_action(jsb)
        return ld
        """,
        ["jsb"],
    ),
    "a list that is put together": (
        """
        nodes = [Node(package='controller_manager', executable='spawner', arguments=['jsb'])]
        nodes += [Node(package='controller_manager', executable='spawner', arguments=['arm'])]
        return LaunchDescription([DeclareLaunchArgument('x')] + nodes)
        """,
        ["jsb", "arm"],
    ),
    "what follows the end of another": (
        """
        jsb = ExecuteProcess(cmd=['ros2', 'control', 'load_controller', '--set-state', 'active', 'jsb'])
        arm = ExecuteProcess(cmd=['ros2', 'control', 'load_controller', '--set-state', 'active', 'arm'])
        return LaunchDescription([
            RegisterEventHandler(event_handler=OnProcessExit(target_action=jsb, on_exit=[arm])), jsb])
        """,
        ["jsb", "arm"],
    ),
    "an argument's default": (
        """
        return LaunchDescription([
            DeclareLaunchArgument('controller', default_value='arm'),
            Node(package='controller_manager', executable='spawner', arguments=[LaunchConfiguration('controller')])])
        """,
        ["arm"],
    ),
    "a function that is called with the context": (
        """
        def setup(context, *args, **kwargs):
            name = LaunchConfiguration('prefix').perform(context) + 'arm'
            if LaunchConfiguration('sim').perform(context) == 'true':
                return [Node(package='controller_manager', executable='spawner', arguments=[name])]
            return [Node(package='controller_manager', executable='spawner', arguments=['real'])]
        return LaunchDescription([DeclareLaunchArgument('prefix', default_value='l_'),
            DeclareLaunchArgument('sim', default_value='true'), OpaqueFunction(function=setup)])
        """,
        ["l_arm"],
    ),
    "the helper of controller_manager": (
        """
        return LaunchDescription([generate_load_controller_launch_description(controller_name='arm'),
            generate_controllers_spawner_launch_description(['jsb', 'hand'])])
        """,
        ["arm", "jsb", "hand"],
    ),
    "a shell's command": (
        """
        return LaunchDescription([ExecuteProcess(
            cmd=['ros2 control load_controller --set-state active arm'], shell=True)])
        """,
        ["arm"],
    ),
    "a dict's items": (
        """
        controllers = {'jsb': [], 'arm': ['--inactive']}
        return LaunchDescription([
            Node(package='controller_manager', executable='spawner', arguments=[name, *more])
            for name, more in controllers.items()])
        """,
        ["jsb", "arm"],
    ),
    "lists that are changed": (
        """
        active, inactive = ['jsb'], ['arm', 'hand']
        if 'x' == 'x':
            active.append('arm')
            inactive.remove('arm')
        return LaunchDescription([
            Node(package='controller_manager', executable='spawner', arguments=['-c', '/controller_manager'] + names)
            for names in (active, inactive)])
        """,
        ["jsb", "arm", "hand"],
    ),
    "words of a sentence": (
        """
        return LaunchDescription([
            Node(package='controller_manager', executable='spawner', arguments='jsb arm'.split())])
        """,
        ["jsb", "arm"],
    ),
}


@pytest.mark.parametrize(("body", "found"), IDIOMS.values(), ids=IDIOMS)
def test_spawners_are_found_however_they_are_written(body: str, found: list[str]) -> None:
    made = launch(body)
    assert names(made) == found
    assert made.complete
    assert all(one.sure and one.complete for one in made.spawns)


def test_a_name_stands_where_it_is_written() -> None:
    made = launch("""
        names = ['jsb', 'arm']
        return LaunchDescription([
            Node(package='controller_manager', executable='spawner', arguments=[n]) for n in names])
        """)
    assert [at.span.text for one in made.spawns for _, at in one.names] == ["jsb", "arm"]


@pytest.mark.parametrize(
    ("words", "more", "manager", "namespace", "active"),
    [
        (("a",), "", "controller_manager", "", True),
        (("a", "--inactive"), "", "controller_manager", "", False),
        (("a", "-c", "/r/controller_manager"), "", "controller_manager", "/r", True),
        (("a", "--controller-manager=/r/cm"), "", "cm", "/r", True),
        (("a", "-c", "cm"), ", namespace='r'", "cm", "/r", True),
        (("a",), ", namespace='/r'", "controller_manager", "/r", True),
        (("a", "--namespace", "/q"), ", namespace='r'", "controller_manager", "/q", True),
    ],
)
def test_a_spawner_tells_its_manager(
    words: tuple[str, ...], more: str, manager: str, namespace: str, active: bool
) -> None:
    one = spawn(launch(spawner(*words, more=more)))
    assert (one.manager, one.namespace, one.active) == (manager, namespace, active)


@pytest.mark.parametrize(
    ("test", "found"),
    [
        ("LaunchConfiguration('real') == 'true'", ["mock"]),
        ("LaunchConfiguration('real') != 'true'", ["arm"]),
        ("LaunchConfiguration('real')", ["arm"]),
        ("LaunchConfiguration('real').perform(context) == 'true'", ["arm"]),
    ],
)
def test_a_substitution_is_an_object_in_a_comparison_whatever_the_argument_is(test: str, found: list[str]) -> None:
    made = launch(f"""
        def setup(context):
            chosen = 'arm' if {test} else 'mock'
            return [Node(package='controller_manager', executable='spawner', arguments=[chosen])]
        return LaunchDescription([
            DeclareLaunchArgument('real', default_value='true'), OpaqueFunction(function=setup)])
        """)
    assert names(made) == found


UNSURE = {
    "a condition that is not known": "if os.path.exists('/x'):\n    nodes.append(arm)",
    "a loop over what is not known": "for _ in os.listdir('.'):\n    nodes.append(arm)",
    "a loop that may not end": "while busy():\n    nodes.append(arm)",
    "a return before": "if os.path.exists('/x'):\n    return LaunchDescription([])\nnodes.append(arm)",
    "a choice": "nodes.append(arm if maybe() else None)",
}


@pytest.mark.parametrize("statement", UNSURE.values(), ids=UNSURE)
def test_what_hangs_on_something_unknown_is_not_sure(statement: str) -> None:
    made = launch(
        "arm = Node(package='controller_manager', executable='spawner', arguments=['arm'])\n"
        f"nodes = []\n{statement}\nreturn LaunchDescription(nodes)"
    )
    assert made.started is None
    assert not any(one.sure for one in made.spawns)


UNKNOWN_ACTIONS = {
    "another module's function": "make_spawners()",
    "a list from elsewhere": "*actions",
    "a file that is not there": "IncludeLaunchDescription(PythonLaunchDescriptionSource('/p/none.launch.py'))",
    "another package's file": "IncludeLaunchDescription([FindPackageShare('q'), '/launch/x.launch.py'])",
    "a class": "Robot().action",
}


@pytest.mark.parametrize("action", UNKNOWN_ACTIONS.values(), ids=UNKNOWN_ACTIONS)
def test_an_action_that_is_not_known_may_do_anything(action: str) -> None:
    made = launch(spawner("arm") + ", " + action)
    assert names(made) == ["arm"]
    assert not made.complete


@pytest.mark.parametrize("what", ["LogInfo(msg='x')", "SetParameter(name='use_sim_time', value=True)", "None"])
def test_some_actions_are_known_to_be_harmless(what: str) -> None:
    assert launch(f"{spawner('arm')}, {what}").complete


CONDITIONS = {
    "IfCondition(LaunchConfiguration('yes'))": True,
    "UnlessCondition(LaunchConfiguration('yes'))": False,
    "IfCondition(PythonExpression([\"'\", LaunchConfiguration('kind'), \"' == 'arm'\"]))": True,
    "IfCondition(PythonExpression(['not ', LaunchConfiguration('yes')]))": None,
    "LaunchConfigurationEquals('kind', 'leg')": False,
    "IfCondition(NotSubstitution(LaunchConfiguration('yes')))": False,
    "IfCondition(AndSubstitution(LaunchConfiguration('yes'), LaunchConfiguration('unset')))": None,
    "IfCondition(OrSubstitution(LaunchConfiguration('yes'), LaunchConfiguration('unset')))": True,
    "IfCondition(EqualsSubstitution(LaunchConfiguration('kind'), 'arm'))": True,
    "IfCondition(EnvironmentVariable('NOWHERE'))": None,
    "own_condition()": None,
}


@pytest.mark.parametrize(("condition", "held"), CONDITIONS.items())
def test_a_condition_holds_does_not_or_is_not_known(condition: str, held: bool | None) -> None:
    made = launch(
        "DeclareLaunchArgument('yes', default_value='true'), DeclareLaunchArgument('kind', default_value='arm'), "
        + spawner("arm", more=f", condition={condition}")
    )
    if held is False:
        assert not made.spawns
        assert [name for one in made.elsewhere for name, _ in one.names] == ["arm"]
    else:
        assert spawn(made).sure is bool(held)


DESCRIPTIONS = {
    "Command(['xacro ', '/p/r.xacro', ' a:=', LaunchConfiguration('a')])": ("/p/r.xacro", (("a", "1"),)),
    "Command([FindExecutable(name='xacro'), ' ', PathJoinSubstitution([FindPackageShare('p'), 'r.xacro'])])": (
        "/p/r.xacro",
        (),
    ),
    "ParameterValue(Command(['xacro', ' ', os.path.join(get_package_share_directory('p'), 'r.xacro')]), "
    "value_type=str)": ("/p/r.xacro", ()),
    "xacro.process_file('/p/r.xacro', mappings={'a': 'b'}).toxml()": ("/p/r.xacro", (("a", "b"),)),
    "xacro.process_file(os.path.join(get_package_share_directory('p'), 'r.xacro')).toprettyxml(indent=' ')": (
        "/p/r.xacro",
        (),
    ),
    "open('/p/r.urdf').read()": ("/p/r.urdf", ()),
    "LaunchConfiguration('description')": ("/p/d.xacro", (("a", "1"),)),
    "Command(['xacro ', LaunchConfiguration('unset'), ' a:=2'])": (None, (("a", "2"),)),
    "Command(['xacro /p/r.xacro a:=', LaunchConfiguration('unset')])": ("/p/r.xacro", (("a", UNKNOWN),)),
    "MoveItConfigsBuilder('r', package_name='p').robot_description(mappings={'a': '1'}).to_moveit_configs()"
    ".robot_description['robot_description']": ("/p/config/r.urdf.xacro", (("a", "1"),)),
    "re.sub('<!--.*-->', '', xacro.process_file('/p/r.xacro').toxml(), flags=re.DOTALL)": ("/p/r.xacro", ()),
    "str(xacro.process_file('/p/r.xacro').toxml().replace('a', 'b'))": ("/p/r.xacro", ()),
    "Command([FindExecutable(name='xacro'), ' ', FindPackageShare(package='p').find('p') + '/r.xacro'])": (
        "/p/r.xacro",
        (),
    ),
    "Command(['xacro ', PythonExpression([\"'\", FindPackageShare('p'), \"' + '/r.xacro'\"])])": ("/p/r.xacro", ()),
    "Command(['xacro /p/r.xacro a:=', PythonExpression([f\"{dict(one=1, two=2)}['\", 'two', \"']\"])])": (
        "/p/r.xacro",
        (("a", "2"),),
    ),
    "Command(['xacro /p/', 'no.xacro' if '--no' in sys.argv[1:] else 'r.xacro'])": ("/p/r.xacro", ()),
    "subprocess.check_output(['xacro', '/p/r.xacro', 'a:=1']).decode('utf-8')": ("/p/r.xacro", (("a", "1"),)),
    "subprocess.run(['xacro', '/p/r.xacro'], stdout=subprocess.PIPE, text=True).stdout": ("/p/r.xacro", ()),
    "os.popen('xacro /p/r.xacro').read()": ("/p/r.xacro", ()),
    "subprocess.check_output(['hostname'])": (None, None),
    "text": (None, None),
}


@pytest.mark.parametrize(("value", "found"), DESCRIPTIONS.items())
def test_a_description_tells_its_file_and_arguments(
    value: str, found: tuple[str | None, tuple[tuple[str, str], ...] | None]
) -> None:
    made = launch(
        "DeclareLaunchArgument('a', default_value='1'), "
        "DeclareLaunchArgument('description', "
        "default_value=Command(['xacro /p/d.xacro a:=', LaunchConfiguration('a')])), "
        f"Node(package='robot_state_publisher', executable='robot_state_publisher', "
        f"parameters=[{{'robot_description': {value}}}])"
    )
    (description,) = made.descriptions
    assert (description.file.path, description.arguments) == found


def test_a_choice_of_the_environment_gives_each_of_its_arguments() -> None:
    made = launch("""
        value = 'yes' if os.environ['ROS_DISTRO'] == 'humble' else 'no'
        description = Command(['xacro /p/r.xacro a:=', value])
        return LaunchDescription([Node(package='robot_state_publisher', executable='robot_state_publisher',
                                       parameters=[{'robot_description': description}])])
        """)
    (description,) = made.robots
    assert (description.arguments, description.alternatives) == ((("a", "yes"),), ((("a", "no"),),))


def test_a_list_inside_the_parameters_is_one_path_in_parts() -> None:
    made = launch("""
        folder = '/p/config/'
        node = Node(package='moveit_ros_move_group', executable='move_group',
                    parameters=[[folder, LaunchConfiguration('pipeline'), '_planning.yaml'], [folder, 'c.yaml']])
        return LaunchDescription([DeclareLaunchArgument('pipeline', default_value='ompl'), node])
        """)
    assert [one.file.path for one in made.references] == ["/p/config/ompl_planning.yaml", "/p/config/c.yaml"]


def test_arguments_that_a_loop_over_unknown_values_adds_are_unknown() -> None:
    made = launch("""
        words = ''
        for name in read_names():
            words = ''.join([words, ' prefix_', name, ':=', name])
        text = Command(['xacro /p/r.xacro', words])
        node = Node(package='robot_state_publisher', executable='robot_state_publisher',
                    parameters=[{'robot_description': text}])
        return LaunchDescription([node])
        """)
    (description,) = made.robots
    assert (description.file.path, description.arguments, description.more) == ("/p/r.xacro", (), True)


def test_what_an_environment_variable_decides_may_be_or_not() -> None:
    made = launch("""
        value = LaunchConfiguration('f')
        group = GroupAction([
            DeclareLaunchArgument('f', default_value='/p/c.yaml'),
            Node(package='controller_manager', executable='ros2_control_node', parameters=[value])],
            condition=IfCondition(EnvironmentVariable('READY', default_value='false')))
        after = Node(package='controller_manager', executable='spawner', arguments=['arm', '-p', value])
        return LaunchDescription([group, after])
        """)
    assert [(load.file.path, load.sure) for load in made.loads] == [("/p/c.yaml", False), (None, True)]


def test_the_description_of_another_node_is_no_other_one() -> None:
    made = launch("""
        first = Node(package='robot_state_publisher', executable='robot_state_publisher',
                     parameters=[{'robot_description': Command(['xacro /p/r.xacro'])}])
        text = Command(['ros2 param get --hide-type /robot_state_publisher robot_description'])
        second = Node(package='controller_manager', executable='ros2_control_node',
                      parameters=[{'robot_description': text}])
        return LaunchDescription([first, second])
        """)
    assert [robot.file.path for robot in made.robots] == ["/p/r.xacro"]


def test_a_file_whose_texts_are_replaced_is_loaded() -> None:
    made = launch("""
        file = ReplaceString('/p/c.yaml', {'<namespace>/': LaunchConfiguration('n', default='a/')})
        return LaunchDescription([Node(package='controller_manager', executable='ros2_control_node',
                                       parameters=[ParameterFile(file, allow_substs=True)])])
        """)
    (load,) = made.loads
    assert (load.file.path, load.rewriting.texts) == ("/p/c.yaml", (("<namespace>/", "a/"),))


def test_xacro_that_is_parsed_and_processed_is_a_description() -> None:
    made = launch("""
        path = os.path.join(get_package_share_directory('p'), 'r.xacro')
        doc = xacro.parse(open(path))
        xacro.process_doc(doc, mappings={'a': 'b'})
        params = {'robot_description': doc.toxml()}
        return LaunchDescription([
            Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[params])])
        """)
    assert [(d.file.path, d.arguments) for d in made.descriptions] == [("/p/r.xacro", (("a", "b"),))]


def test_a_manager_loads_the_files_it_is_given() -> None:
    made = launch("""
        params = PathJoinSubstitution([FindPackageShare('p'), 'config', 'c.yaml'])
        return LaunchDescription([Node(package='controller_manager', executable='ros2_control_node',
            parameters=[params, {'update_rate': 100}, ParameterFile('/p/d.yaml', allow_substs=True)])])
        """)
    assert [load.file.path for load in made.loads] == ["/p/config/c.yaml", "/p/d.yaml"]
    (node,) = made.nodes
    assert [word.text for word in node.parameters] == ["update_rate"]
    assert node.complete


def test_a_spawner_loads_its_parameter_file() -> None:
    made = launch(spawner("arm", "--param-file", "/p/c.yaml", "-p", "/p/d.yaml"))
    assert [file.path for file in spawn(made).files] == ["/p/c.yaml", "/p/d.yaml"]
    assert [load.node for load in made.loads] == ["spawner", "spawner"]


def test_included_files_are_followed_with_their_arguments() -> None:
    made = launch(
        """
        return LaunchDescription([IncludeLaunchDescription(
            PythonLaunchDescriptionSource([get_package_share_directory('p'), '/inner.launch.py']),
            launch_arguments={'name': 'arm'}.items())])
        """,
        inner="""
        def generate_launch_description():
            return LaunchDescription([
                DeclareLaunchArgument('name', default_value='other'),
                Node(package='controller_manager', executable='spawner', arguments=[LaunchConfiguration('name')])])
        """,
    )
    assert names(made) == ["arm"]
    assert made.complete


def test_groups_keep_what_they_set_to_themselves() -> None:
    made = launch(f"GroupAction([PushRosNamespace('r'), {spawner('a')}]), {spawner('b')}")
    assert [(one.names[0][0], one.namespace) for one in made.spawns] == [("a", "/r"), ("b", "")]


def test_a_file_that_includes_itself_comes_to_an_end() -> None:
    made = launch("IncludeLaunchDescription('/p/main.launch.py'), " + spawner("arm"))
    assert not made.complete


GZ = "IncludeLaunchDescription([FindPackageShare('ros_gz_sim'), '/launch/gz_sim.launch.py'], "
SIMULATORS = {
    GZ + "launch_arguments={'gz_args': '-r empty.sdf'}.items())": ("gz", False),
    GZ + "launch_arguments={'gz_args': [world, ' -v4']}.items())": ("gz", None),
    GZ + "launch_arguments=[('gz_args', 'empty.sdf')])": ("gz", True),
    "IncludeLaunchDescription([FindPackageShare('gazebo_ros'), '/launch/gazebo.launch.py'])": ("gazebo-classic", False),
    "ExecuteProcess(cmd=['gz', 'sim', '-r', 'x.sdf'])": ("gz", False),
}


@pytest.mark.parametrize(("action", "found"), SIMULATORS.items())
def test_simulators_are_started_paused_or_not(action: str, found: tuple[str, bool | None]) -> None:
    made = launch(action)
    assert [(one.simulator, one.paused) for one in made.simulations] == [found]
    assert made.complete


@pytest.mark.parametrize(
    "action", [GZ + "launch_arguments={'gz_args': '-g'}.items())", "ExecuteProcess(cmd=['gz', 'sim', '-g'])"]
)
def test_a_window_of_gz_alone_is_no_simulation(action: str) -> None:
    assert not launch(action).simulations


COUNTED = {
    "for i in range(2)": ["arm1", "arm2"],
    "for i in range(1, int('4'), 2)": ["arm2", "arm4"],
    "for i, _ in enumerate(['x', 'y'])": ["arm1", "arm2"],
    "for i, _ in enumerate(['x'], start=4)": ["arm5"],
    "for i, _ in zip([7, 8], ['x', 'y', 'z'])": ["arm8", "arm9"],
    "for i in reversed([0, 1])": ["arm2", "arm1"],
    "for i in range(len(['x', 'y']) - 1)": ["arm1"],
    "for i in [7 // 2 * 3, 7 % 4]": ["arm10", "arm4"],
}


@pytest.mark.parametrize(("loop", "expected"), COUNTED.items())
def test_loops_that_count_are_followed(loop: str, expected: list[str]) -> None:
    made = launch(f"""
        ld = LaunchDescription()
        {loop}:
            ld.add_action(Node(package='controller_manager', executable='spawner', arguments=[f'arm{{i + 1}}']))
        return ld
    """)
    assert names(made) == expected
    assert made.complete


@pytest.mark.parametrize(
    "loop", ["for i in range(int(os.environ['N']))", "for i in range(10 ** 12)", "for i in [1 / 0]"]
)
def test_a_loop_that_counts_to_what_is_not_known_spawns_what_is_not_known(loop: str) -> None:
    made = launch(f"""
        ld = LaunchDescription()
        {loop}:
            ld.add_action(Node(package='controller_manager', executable='spawner', arguments=[f'arm{{i}}']))
        return ld
    """)
    assert [name for name in names(made) if UNKNOWN not in name] == []


def test_the_folder_of_a_package_that_is_not_here_stays_the_same_after_a_condition() -> None:
    made = launch("""
        share = get_package_share_directory('ros_gz_sim')
        paths = [share]
        if os.path.exists('/models'):
            paths.append('/models')
        gz = PythonLaunchDescriptionSource(os.path.join(share, 'launch', 'gz_sim.launch.py'))
        return LaunchDescription([IncludeLaunchDescription(gz, launch_arguments={'gz_args': '-r'}.items())])
    """)
    assert [one.simulator for one in made.simulations] == ["gz"]
    assert made.complete


@pytest.mark.parametrize("text", ENDLESS.values(), ids=ENDLESS)
def test_hostile_files_come_to_an_end(text: str) -> None:
    indented = "".join(f"    {line}\n" for line in text.splitlines())
    launch(f"def generate_launch_description():\n{indented}    return LaunchDescription([])\n")
