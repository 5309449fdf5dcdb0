package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.policy.PolicyRule.Effect;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Each fault of a policy is reported with its line and a remedy. */
class PolicyReaderTest {

  private static final String GOOD = "<permit role=\"operator\"/>";

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "<permit role=\"boss\"/> | role \"boss\" is none of robot, operator, observer",
        "<permit standing=\"friend\"/> | standing \"friend\" is none of own, member, expired",
        "<permit kind=\"fly\"/> | kind \"fly\" is none of read, listen",
        "<permit rol=\"robot\"/> | the attribute rol is not known in <permit>; did you mean \"role\"",
        "<permt/> | <permt> is not known here; did you mean \"permit\"",
        "<permit><rat max=\"1\" per=\"1s\"/></permit> | <rat> is not known here; did you mean \"rate\"",
        "<permit interface=\"DriveEfector\"/> | no remote interface \"DriveEfector\"; did you mean \"Dr",
        "<permit interface=\"Effector\" method=\"exekute\"/> | has no method \"exekute\"; did you mean",
        "<permit method=\"zap\"/> | no remote interface has no method \"zap\"",
        "<permit method=\"\"/> | method names nothing; delete it, or write a name",
        "<permit member=\"an na\"/> | member: \"an na\" is no name",
        "<permit same-robot=\"maybe\"/> | same-robot is \"maybe\"; write yes or no",
        "<permit name=\"default\"/> | a rule cannot be named default",
        "<permit name=\"a,b\"/> | \"a,b\" is no name",
        "<permit><within region=\"hall\"/></permit> | there is no region \"hall\"; add <region name=",
        "<permit><when/></permit> | <when> has neither from nor until",
        "<permit><when from=\"noon\"/></permit> | is no time; write instants",
        "<permit><when from=\"06:00\"/></permit> | <when> has one time of day",
        "<permit><when from=\"06:00\" until=\"06:00\"/></permit> | is never; write two times",
        "<permit><when from=\"29:00\" until=\"06:00\"/></permit> | is no time",
        "<permit><while fact=\"Load\" is=\"none\"/></permit> | fact \"Load\" is no name",
        "<permit><while fact=\"load\"/></permit> | <while> lacks its is",
        "<permit><rate max=\"0\" per=\"1s\"/></permit> | max 0 is outside 1 to 1000",
        "<permit><rate max=\"5\" per=\"2h\"/></permit> | is outside 1 ms to 3600 s",
        "<permit><rate max=\"5\" per=\"fast\"/></permit> | is no rate; write it as max=\"5\" per=\"1s\"",
        "<permit><rate max=\"1\" per=\"1s\"/><rate max=\"2\" per=\"1s\"/></permit> | several <rate>",
        "<deny><ask/></deny> | a <deny> has <rate> or <ask>",
        "<permit><log>text</log></permit> | <log> must be empty",
        "<budget role=\"observer\"/> | the budget limits nothing; add bytes, calls, processor-time or",
        "<budget role=\"boss\" calls=\"5/s\"/> | role \"boss\" is none of robot, operator, observer",
        "<budget name=\"a b\" calls=\"5/s\"/> | \"a b\" is no name",
        "<budget calls=\"5\"/> | <budget> calls \"5\" is no limit above 0; write it as calls=\"100/s\"",
        "<budget calls=\"0/s\"/> | calls \"0/s\" is no limit above 0",
        "<budget bytes=\"64KB/s\"/> | bytes \"64KB/s\" is no limit above 0; write it as bytes=\"64kB/s\"",
        "<budget processor-time=\"50%\"/> | write it as processor-time=\"50ms/s\"",
        "<budget listeners=\"-1\"/> | write it as listeners=\"8\"",
        "<budget calls=\"5/s\" per=\"robot\"/> | per is \"robot\"; write caller or object",
        "<budget calls=\"5/s\" exceeded=\"stop\"/> | exceeded is \"stop\"; write refuse or slow",
        "<budget cals=\"5/s\"/> | the attribute cals is not known in <budget>; did you mean \"calls\"",
        "<budget calls=\"5/s\"><log/></budget> | <budget> must be empty",
        "<radio/> | <radio> lacks its max",
        "<radio max=\"fast\"/> | <radio> max \"fast\" is no limit above 0; write it as max=\"64kB/s\"",
        "<region name=\"a\"><corner latitude=\"1\" longitude=\"1\"/></region> | 1 corners is outside 3",
        "<region name=\"a\"><corner latitude=\"x\" longitude=\"1\"/></region> | is not two numbers",
        "<region name=\"a\"><corner latitude=\"91\" longitude=\"1\"/></region> | latitude 91.0° is outside",
      })
  void reportsAFaultWithItsLine(String line, String sentence) {
    assertThatThrownBy(() -> PolicyFixture.policy(GOOD, line, GOOD))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("policy.xml:3: ")
        .hasMessageContaining(sentence);
  }

  @Test
  void reportsAllFaultsAtOnceInTheirOrder() {
    assertThatThrownBy(
            () ->
                PolicyFixture.policy(
                    "<permit role=\"boss\"/>", GOOD, "<deny kind=\"fly\" robot=\"?\"/>"))
        .hasMessageMatching("(?s)policy.xml:2: [^\n]*\npolicy.xml:4: [^\n]*\npolicy.xml:4: [^\n]*");
  }

  @Test
  void refusesADocumentThatIsNoPolicyOrHasNoRule() {
    assertThatThrownBy(() -> PolicyFixture.read("<policy team=\"field\" version=\"1\"/>"))
        .hasMessageContaining("policy.xml:1: the root element is <policy> in no namespace");
    assertThatThrownBy(() -> PolicyFixture.policy())
        .hasMessageContaining("policy.xml:1: the policy has no rule, so it refuses every call");
    String badHead = PolicyFixture.xml(1, GOOD).replace("\"field\"", "\"a b\"");
    assertThatThrownBy(() -> PolicyFixture.read(badHead.replace("\"1\"", "\"-1\"")))
        .hasMessageContaining("policy.xml:1: team \"a b\" is not")
        .hasMessageContaining("policy.xml:1: version \"-1\" is not a whole number");
    assertThatThrownBy(() -> PolicyFixture.read("<!DOCTYPE a>" + PolicyFixture.xml(1, GOOD)))
        .hasMessageContaining("a document type is not allowed");
  }

  @Test
  void boundsTheSizeTheDepthAndTheNumberOfRules() {
    String blanks = " ".repeat(PolicyXml.MAX_BYTES);
    assertThatThrownBy(() -> PolicyFixture.policy(GOOD, blanks))
        .hasMessageContaining("bytes, at most 262144 are read");
    String deep = "<permit>".repeat(2000) + "</permit>".repeat(2000);
    assertThatThrownBy(() -> PolicyFixture.policy(deep))
        .hasMessageContaining("policy.xml:2: elements are nested deeper than 64");
    assertThatThrownBy(() -> PolicyFixture.policy("<permit/>".repeat(501)))
        .hasMessageContaining("the policy has 501 rules, at most 500 are read");
  }

  @Test
  void refusesTwoRulesOrTwoRegionsOfOneName() {
    String named = "<permit name=\"a\"/>";
    assertThatThrownBy(() -> PolicyFixture.policy(named, GOOD, named))
        .hasMessageContaining("policy.xml:4: there is a second rule a, the first is in line 2");
  }

  @Test
  void refusesASimpleNameThatSeveralInterfacesHave() {
    InterfaceCatalogue two =
        InterfaceCatalogue.parse("a.Lamp\n\ton\tread\tx\nb.Lamp\n\ton\tread\tx\n");
    String xml = PolicyFixture.xml(1, "<permit interface=\"Lamp\"/>");
    assertThatThrownBy(
            () -> PolicyXml.read(xml.getBytes(StandardCharsets.UTF_8), "policy.xml", two))
        .hasMessageContaining("several interfaces are named Lamp; write a.Lamp or b.Lamp");
    String full = PolicyFixture.xml(1, "<permit interface=\"b.Lamp\" method=\"on\"/>");
    assertThat(PolicyXml.read(full.getBytes(StandardCharsets.UTF_8), "policy.xml", two).rules())
        .hasSize(1);
  }

  @Test
  void readsRulesInTheirOrderWithNamesPlacesConditionsAndObligations() {
    Policy policy =
        PolicyFixture.policy(
            "<region name=\"hall\"><corner latitude=\"0\" longitude=\"0\"/>"
                + "<corner latitude=\"0\" longitude=\"1\"/><corner latitude=\"1\" longitude=\"1\"/></region>",
            "<deny interface=\"*\" method=\"*\" standing=\"stranger\"/>",
            "<permit name=\"shift\" role=\"robot, operator\"><within region=\"hall\"/>"
                + "<when from=\"22:00\" until=\"06:00\"/><while fact=\"load\" is=\"none\"/>"
                + "<rate max=\"5\" per=\"500ms\"/><log/><notify/><ask/></permit>");

    List<PolicyRule> rules = policy.rules();
    assertThat(rules).extracting(PolicyRule::name).containsExactly("line 3", "shift");
    assertThat(rules).extracting(PolicyRule::effect).containsExactly(Effect.DENY, Effect.PERMIT);
    assertThat(rules.get(1).place()).hasToString("policy.xml:4");
    assertThat(rules.get(1).conditions())
        .containsExactly(
            "within region hall", "from 22:00 until 06:00 UTC on each day", "while load is none");
    assertThat(rules.get(1).obligations().inWords())
        .containsExactly(
            "an operator must confirm it",
            "at most 5 calls in 500 ms",
            "it is logged",
            "operators are notified");
    assertThat(policy).hasToString("policy 1 of field");
  }
}
