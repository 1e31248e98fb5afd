"""Small documents, one for each feature of xacro: a name and its files, the first of which is expanded.

A string instead of files is the body of a robot in `r.xacro`.
"""

# ruff: noqa: E501 (the documents are literal)
from __future__ import annotations

from expansion import NAMESPACE

INCLUDED = f"""<robot {NAMESPACE} xmlns:extra="http://extra">
  <!-- of the included file -->
  <xacro:property name="length" value="0.5"/>
  <xacro:macro name="arm" params="side:=left"><link name="${{side}}_arm" l="${{length}}"/></xacro:macro>
  <link name="from_included"/>
</robot>
"""
PARAMETERS = """<arm>
  length: !millimeters 1500
  angle: !degrees 90
  foot: !foot 1
  inch: !inches ${1 + 1}
  radius: !radians 1.5
  plain: !meters 2
  joints: [a, b, {name: c, limits: {lower: -1, upper: 1.5e0}}]
  enabled: true
  empty:
  text: 12:30
  float: 1e3
</arm>
""".replace("<arm>\n", "").replace("</arm>\n", "")

FEATURES: dict[str, str | dict[str, str]] = {
    "plain elements": '<link name="a"/>\n  <!-- stays -->\n  <joint name="j" type="fixed"> text </joint>',
    "arithmetic": '<a b="${1 + 2}" c="${1.0 / 3}" d="${2 * pi}" e="${-1e-6}" f="x${1}y${2.5}" g="${True}" h="${None}"/>',
    "functions of math": '<a b="${sin(radians(90))}" c="${math.sqrt(2)}" d="${atan2(1, 2)}" e="${floor(2.5)}" f="${inf}"/>',
    "texts in expressions": """<a b="${'x' + 'y'}" c="${'a,b'.split(',')[1]}" d="${str(1) + 'm'}" e="${'%.2f' % 1.5}"/>""",
    "escaped dollars": '<a b="$${x}" c="$$(arg x)" d="$$${x}" e="$" f="a$b" g="$x{1}"/>',
    "escaped characters": '<a b="&lt;&amp;&gt;&quot;" c="&#10;&#9;">${1 &lt; 2} &amp; &lt;</a>',
    "a property": '<xacro:property name="x" value="1"/>\n<a b="${x}" c="${x + 1}" d="${x}${x}"/>',
    "lazy evaluation": '<xacro:property name="x" value="${y + 1}"/><xacro:property name="y" value="2"/><a b="${x}"/>'
    '<xacro:property name="y" value="5"/><a b="${x}"/>',
    "greedy evaluation": '<xacro:property name="y" value="2"/><xacro:property name="x" value="${y}" lazy_eval="false"/>'
    '<xacro:property name="y" value="5"/><a b="${x}"/>',
    "literals of properties": """<xacro:property name="a" value="1_000"/><xacro:property name="b" value="'1'"/>
<xacro:property name="c" value="true"/><xacro:property name="d" value=" 1 "/><xacro:property name="e" value=""/>
<r a="${a}" b="${b + 1}" c="${not c}" d="${d + 1}" e="[${e}]"/>""",
    "a default that is kept": '<xacro:property name="x" value="1"/><xacro:property name="x" default="2"/><a b="${x}"/>',
    "a default that is taken": '<xacro:property name="x" default="2"/><a b="${x}"/>',
    "a removed property": '<xacro:property name="x" value="1"/><xacro:property name="x" remove="true"/>'
    '<xacro:property name="x" default="3"/><a b="${x}"/>',
    "scopes of properties": """<xacro:macro name="m"><xacro:property name="up" value="${1 + 1}" scope="parent"/>
<xacro:property name="far" value="3" scope="global"/><xacro:property name="here" value="4"/><in v="${here}"/></xacro:macro>
<xacro:macro name="outer"><xacro:m/><o up="${up}" far="${far}"/></xacro:macro>
<xacro:property name="here" value="0"/><xacro:outer/><a far="${far}" here="${here}"/>""",
    "a property that is a block": """<xacro:property name="origin"><origin xyz="0 0 ${z}"/><!-- c --></xacro:property>
<xacro:property name="z" value="1"/><a><xacro:insert_block name="origin"/></a><b><xacro:insert_block name="origin"/></b>""",
    "a computed name of a property": '<xacro:property name="n" value="x"/><xacro:property name="${n}_1" value="2"/><a b="${x_1}"/>',
    "a list in a property": """<xacro:property name="l" value="${[1, 'b', 2.5]}"/>
<xacro:property name="d" value="${dict(a=1, b=dict(c=2))}"/>
<a b="${l[1]}" c="${len(l)}" d="${d['b']['c']}" e="${[i * 2 for i in [1, 2]]}"/>""",
    "dotify": """<xacro:property name="d" value="${xacro.dotify(dict(a=dict(b=[dict(c=7)])))}"/>
<a b="${d.a.b[0].c}" c="${d['a'].b[0]['c']}"/>""",
    "tokenize": """<a b="${xacro.tokenize('1; 2,3  4')}" c="${xacro.tokenize('a-b', sep='-', skip_empty=False)}"/>""",
    "the namespace python": """<a b="${python.sorted([2, 1])}" c="${list(python.range(3))}" d="${python.abs(-1)}"
e="${python.isinstance(1, python.int)}" f="${python.any([0, 1])}" g="${list(python.zip([1], [2]))}" h="${python.type(1)}"/>""",
    "a macro": '<xacro:macro name="m" params="a b"><l n="${a}" m="${b}"/></xacro:macro><xacro:m a="1" b="${1 + 1}"/>',
    "defaults of a macro": """<xacro:macro name="m" params="a:=1 b='x y' c=&quot;q r&quot; d:=${1 + 2} e=$(arg e) f:=''">
<l a="${a}" b="${b}" c="${c}" d="${d}" e="${e}" f="[${f}]"/></xacro:macro><xacro:arg name="e" default="E"/>
<xacro:m/><xacro:m a="9" f="F"/>""",
    "forwarded parameters": """<xacro:macro name="m" params="a:=^ b:=^|7 c:=^|${1 + 1} d=^"><l a="${a}" b="${b}" c="${c}" d="${d}"/></xacro:macro>
<xacro:property name="a" value="1"/><xacro:property name="d" value="4"/><xacro:m/><xacro:property name="b" value="2"/><xacro:m/>""",
    "parameters on lines of their own": """<xacro:macro name="m" params="
    a
    b:=2
    *c
    **d"><l a="${a}" b="${b}"><xacro:insert_block name="c"/><xacro:insert_block name="d"/></l></xacro:macro>
<xacro:m a="1"><one x="${1}"/><many><two/>text<three/></many></xacro:m>""",
    "a block inserted twice": """<xacro:macro name="m" params="*o"><a><xacro:insert_block name="o"/></a><b><xacro:insert_block name="o"/></b></xacro:macro>
<xacro:property name="z" value="1"/><xacro:m><origin xyz="${z}"/></xacro:m>""",
    "a block handed on": """<xacro:macro name="inner" params="n *o"><in n="${n}"><xacro:insert_block name="o"/></in></xacro:macro>
<xacro:macro name="outer" params="*o"><xacro:inner n="1"><xacro:insert_block name="o"/></xacro:inner></xacro:macro>
<xacro:outer><origin/></xacro:outer>""",
    "a macro called in a block": """<xacro:macro name="leaf" params="n"><leaf n="${n}"/><leaf n="${n}b"/></xacro:macro>
<xacro:macro name="wrap" params="**all"><w><xacro:insert_block name="all"/></w></xacro:macro>
<xacro:wrap><all><xacro:leaf n="1"/></all></xacro:wrap>""",
    "a macro defined in a macro": """<xacro:macro name="m"><xacro:macro name="k"><k/></xacro:macro><xacro:k/></xacro:macro><xacro:m/>""",
    "a macro that calls itself": """<xacro:macro name="chain" params="n"><link n="${n}"/><xacro:if value="${n > 0}"><xacro:chain n="${n - 1}"/></xacro:if></xacro:macro>
<xacro:chain n="3"/>""",
    "a macro redefined": '<xacro:macro name="m"><a/></xacro:macro><xacro:m/><xacro:macro name="m"><b/></xacro:macro><xacro:m/>',
    "a macro with xacro's prefix in its name": '<xacro:macro name="xacro:m"><a/></xacro:macro><xacro:m/>',
    "namespaces brought by a macro": '<xacro:macro name="m" xmlns:s="http://s"><s:a/></xacro:macro><xacro:m/><xacro:m/>',
    "a dynamic call": '<xacro:macro name="m_1" params="a"><l a="${a}"/></xacro:macro><xacro:property name="n" value="1"/>'
    '<xacro:call macro="m_${n}" a="2"/>',
    "a dynamic element": '<xacro:property name="n" value="joint"/><xacro:element xacro:name="${n}" type="t"><c/></xacro:element>',
    "a dynamic attribute": """<link a="1"><xacro:attribute name="b" value="${str(1 + 1)}"/><xacro:attribute name="${'c'}" value="3"/></link>
<link><xacro:attribute name="zero" value="${1 - 1}"/></link>
<joint><xacro:if value="true"><xacro:attribute name="x" value="y"/></xacro:if></joint>""",
    "conditions": """<xacro:if value="true"><a/></xacro:if><xacro:if value="0"><b/></xacro:if><xacro:unless value="${1 == 2}"><c/></xacro:unless>
<xacro:if value="${1 &lt; 2 and 'x' in 'xy'}"><d/>text<e/></xacro:if><xacro:unless value="True"><f/></xacro:unless><xacro:if value="${[]}"><g/></xacro:if>""",
    "arguments": '<xacro:arg name="a" default="1"/><xacro:arg name="b" default="$(arg a)2"/><xacro:arg name="given" default="no"/>'
    '<l a="$(arg a)" b="$(arg b)" c="${xacro.arg(\'a\')}" d="$(arg given)" e="x-$(arg a)-y"/>',
    "$(eval)": """<xacro:arg name="a" default="2"/><xacro:arg name="t" default="true"/>
<l a="$(eval 1 + 1)" b="$(eval a * 2)" c="$(eval a + 1)" d="$(eval 'x' if t else 'y')" e="$(eval pi)"/>""",
    "$(cwd)": '<l a="$(cwd)/x"/>',
    "$(optenv)": '<l a="$(optenv URDFCTL_NOT_SET a b)" b="[$(optenv URDFCTL_NOT_SET)]"/>',
    "an expression in $(arg)": """<xacro:arg name="a_1" default="x"/><xacro:property name="n" value="1"/><l b="$(arg a_${n})"/>""",
    "comments before what is taken out": """<!-- of the property -->
<xacro:property name="x" value="1"/>
<!-- stays -->

<xacro:property name="y" value="1"/>
<!-- one --><!-- two -->
<xacro:macro name="m"><!-- in --><a/></xacro:macro>
<!-- call -->
<xacro:m/>
<!-- last -->""",
    "evaluated comments": """<!-- ${1 + 1} --><!-- xacro:eval-comments --><!-- ${1 + 1} --><!-- xacro:eval-comments:off --><!-- ${2} -->
<!-- xacro:eval-comments --><a/><!-- ${3} --><!-- xacro:eval-comments:on -->
 <!-- ${4} $(cwd) -->text<!-- ${5} -->""",
    "texts": '<xacro:property name="x" value="1"/><a> ${x} </a><b>${x}</b><c><![CDATA[${x}]]></c><d><?p ${x}?></d>',
    "attributes of xacro's namespace": '<a xacro:b="1" c="2"/>',
    "messages": "<a b=\"${xacro.warning('careful')}\" c=\"${xacro.message('hello', 1)}\" d=\"${xacro.error('oh')}\"/>",
    "deprecated names": '<a b="${dotify(dict(a=1)).a}" c="${abs_filename(\'/x\')}" d="${list(range(2))}"/>',
    "a target namespace": {"r.xacro": f'<robot {NAMESPACE} xacro:targetNamespace="http://t"><a/></robot>'},
    "a doctype": {
        "r.xacro": f'<?xml version="1.0"?>\n<!DOCTYPE robot>\n<!-- c -->\n<robot {NAMESPACE}><a/></robot>\n<!-- d -->'
    },
    "CRLF and a byte order mark": {
        "r.xacro": f'\ufeff<robot {NAMESPACE}>\r\n<a b="${{1}}"/>\r\n\ttext\r\n</robot>\r\n'
    },
    "an include": {
        "r.xacro": f'<robot {NAMESPACE}>\n<!-- c -->\n<xacro:include filename="sub/i.xacro"/>\n<xacro:arm/><a b="${{length}}"/></robot>',
        "sub/i.xacro": INCLUDED,
    },
    "an include with a namespace": {
        "r.xacro": f'<robot {NAMESPACE}><xacro:property name="length" value="9"/><xacro:include filename="i.xacro" ns="n"/>'
        '<xacro:n.arm side="right"/><a b="${n.length}" c="${length}"/></robot>',
        "i.xacro": INCLUDED,
    },
    "an optional include": '<xacro:include filename="none.xacro" optional="true"/><a/>',
    "includes by a pattern": {
        "r.xacro": f'<robot {NAMESPACE}><xacro:include filename="part_*.xacro"/><xacro:include filename="no_*.xacro"/></robot>',
        "part_b.xacro": "<robot><b/></robot>",
        "part_a.xacro": "<robot><a/></robot>",
    },
    "an include of an include": {
        "r.xacro": f'<robot {NAMESPACE}><xacro:include filename="sub/one.xacro"/></robot>',
        "sub/one.xacro": f'<robot {NAMESPACE}><xacro:include filename="two.xacro"/><one/></robot>',
        "sub/two.xacro": "<robot><two/></robot>",
    },
    "an include of a package": {
        "r.xacro": f'<robot {NAMESPACE}><xacro:include filename="$(find other)/i.xacro"/><m f="file://$(find other)/m.stl"/></robot>',
        "other/package.xml": "<package><name>other</name></package>",
        "other/i.xacro": "<robot><i/></robot>",
    },
    "load_yaml": {
        "r.xacro": f"""<robot {NAMESPACE}><xacro:property name="y" value="${{xacro.load_yaml('p.yaml')}}"/>
<a l="${{y['length']}}" a="${{y.angle}}" f="${{y.foot}}" i="${{y.inch}}" r="${{y.radius}}" p="${{y.plain}}" j="${{y.joints[2].limits.upper}}"
 k="${{y['joints'][0]}}" o="${{y.enabled}}" e="${{y.empty}}" t="${{y.text}}" g="${{y.float}}" n="${{[j for j in y.joints]}}" h="${{y}}"/></robot>""",
        "p.yaml": PARAMETERS.replace("${1 + 1}", "1 + 1"),
    },
}

FAILURES: dict[str, str | dict[str, str]] = {
    "two dollars at the end": '<a b="$$"/>',
    "an undefined name": '<a b="${x}"/>',
    "an undefined name in a property": '<xacro:property name="x" value="${y}"/><a b="${x + 1}"/>',
    "a circle of properties": '<xacro:property name="x" value="${y}"/><xacro:property name="y" value="${x}"/><a b="${x}"/>',
    "no expression": '<a b="${1 +}"/>',
    "a wrong type": "<a b=\"${'a' + 1}\"/>",
    "a division by zero": '<a b="${1 / 0}"/>',
    "an index out of range": '<a b="${[1][2]}"/>',
    "a missing key": "<a b=\"${dict(a=1)['b']}\"/>",
    "a failure in $(eval)": '<a b="$(eval 1 / 0)"/>',
    "a missing attribute of a dictionary": '<a b="${xacro.dotify(dict(a=1)).b}"/>',
    "an expression that is not closed": '<a b="${x"/>',
    "an argument that is not defined": '<a b="$(arg x)"/>',
    "an unknown substitution": '<a b="$(what x)"/>',
    "an argument without a name": '<a b="$(arg)"/>',
    "an unknown macro": "<xacro:m/>",
    "an unknown macro by a call": '<xacro:call macro="m"/>',
    "a call without a macro": '<xacro:call macro=""/>',
    "an unknown namespace": "<xacro:n.m/>",
    "a parameter too many": '<xacro:macro name="m"/><xacro:m a="1"/>',
    "a parameter too few": '<xacro:macro name="m" params="a b:=1 c"/><xacro:m/>',
    "a block too few": '<xacro:macro name="m" params="*a"/><xacro:m/>',
    "a block too many": '<xacro:macro name="m"/><xacro:m><a/></xacro:m>',
    "an undefined block": '<xacro:insert_block name="a"/>',
    "nothing to forward": '<xacro:macro name="m" params="a:=^"/><xacro:m/>',
    "a condition that is none": '<xacro:if value="maybe"/>',
    "an include without a file name": "<xacro:include/>",
    "a property without a name": '<xacro:property value="1"/>',
    "a property of no valid name": '<xacro:property name="a-b" value="1"/>',
    "a property named by a keyword": '<xacro:property name="class" value="1"/>',
    "a hidden property": '<xacro:property name="__a" value="1"/>',
    "a property of two kinds": '<xacro:property name="a" value="1" default="2"/>',
    "a macro without a name": "<xacro:macro/>",
    "a macro named call": '<xacro:macro name="call"/>',
    "a macro with a dot": '<xacro:macro name="a.b"/>',
    "an element without a name": '<xacro:element xacro:name=""/>',
    "an attribute without a name": '<a><xacro:attribute name="" value="1"/></a>',
    "an attribute without a value": '<a><xacro:attribute name="b"/></a>',
    "a failure in a macro in a macro": '<xacro:macro name="k" params="a"><b c="${a + 1}"/></xacro:macro>'
    '<xacro:macro name="m"><xacro:k a="x"/></xacro:macro><xacro:m/>',
    "a fatal message": "<a b=\"${xacro.fatal('stop', 1)}\"/>",
}
