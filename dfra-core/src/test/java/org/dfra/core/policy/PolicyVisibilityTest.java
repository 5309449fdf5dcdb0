package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.query.QueryTypeNames;
import org.dfra.persona.Attributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.dfra.security.Visibility;
import org.dfra.security.Visibility.ListedService;
import org.dfra.security.Visibility.OfService;
import org.junit.jupiter.api.Test;

/** Rules about what lookup services show. */
class PolicyVisibilityTest {

  private static final String MODULE = "org.dfra.persona.ModuleAttributes";
  private static final String GPS = "org.dfra.flow.sensor.GPSSensor";
  private static final Caller STRANGER = Caller.stranger("192.0.2.1");

  private static Policy policy(String... lines) {
    String text =
        "<policy xmlns=\"urn:dfra:policy:1\" team=\"field\" version=\"1\">\n"
            + String.join("\n", lines)
            + "\n<permit standing=\"own\"/></policy>";
    return PolicyXml.read(
        text.getBytes(StandardCharsets.UTF_8), "p.xml", InterfaceCatalogue.builtIn());
  }

  private static Caller caller(Standing standing, MemberRole role, String name) {
    return new Caller(standing, Optional.of(new Member("field", role, name)), "192.0.2.2");
  }

  private static OfService seen(Policy policy, Caller caller, String object, String... types) {
    return new PolicyGuard(policy)
        .visibility(caller)
        .of(new ListedService("atrv1", object, Set.of(types)));
  }

  @Test
  void theFirstRuleThatMatchesDecidesAndWhatNoneMatchesIsShown() {
    Policy policy =
        policy(
            "<show standing=\"stranger\" entry=\"module.name\"/>",
            "<hide standing=\"stranger\" entry=\"module\"/>",
            "<hide standing=\"stranger\" object=\"secret_*\"/>");
    OfService gps = seen(policy, STRANGER, "gps", GPS);
    assertThat(gps.isShown()).isTrue();
    assertThat(gps.isShown(MODULE, "name")).isTrue();
    assertThat(gps.isShown(MODULE, "host")).isFalse();
    assertThat(gps.isShown(MODULE)).as("one hidden component hides all").isFalse();
    assertThat(gps.isShown("net.jini.lookup.entry.Name", "name")).isTrue();
    assertThat(seen(policy, STRANGER, "secret_gps", GPS).isShown()).isFalse();
    Caller otto = caller(Standing.MEMBER, MemberRole.OBSERVER, "otto");
    assertThat(new PolicyGuard(policy).visibility(otto)).isSameAs(Visibility.ALL);
    Caller other =
        new Caller(
            Standing.MEMBER,
            Optional.of(new Member("others", MemberRole.OPERATOR, "anna")),
            "192.0.2.3");
    assertThat(new PolicyGuard(policy).visibility(other).isComplete())
        .as("a member of another team")
        .isFalse();
  }

  @Test
  void rulesMatchByRoleMemberRobotAndType() {
    Policy policy =
        policy(
            "<hide role=\"observer\" type=\"GPSSensor\"/>",
            "<hide role=\"robot\" same-robot=\"no\" entry=\"module.host\"/>",
            "<hide member=\"guest-*\" robot=\"atrv2\"/>");
    Caller otto = caller(Standing.MEMBER, MemberRole.OBSERVER, "otto");
    assertThat(seen(policy, otto, "gps", GPS).isShown()).isFalse();
    assertThat(seen(policy, otto, "drive", "org.dfra.x.Other").isShown()).isTrue();
    Caller first = caller(Standing.MEMBER, MemberRole.ROBOT, "atrv1");
    Caller second = caller(Standing.MEMBER, MemberRole.ROBOT, "atrv2");
    assertThat(seen(policy, first, "gps", GPS).isShown(MODULE, "host")).isTrue();
    assertThat(seen(policy, second, "gps", GPS).isShown(MODULE, "host")).isFalse();
    Caller guest = caller(Standing.MEMBER, MemberRole.OPERATOR, "guest-1");
    assertThat(seen(policy, guest, "gps", GPS).isShown()).isTrue();
  }

  @Test
  void whoMayStopAnEffectorFindsItWhateverIsHidden() {
    Policy policy = policy("<hide/>", "<hide entry=\"*\"/>");
    for (Standing each : List.of(Standing.MEMBER, Standing.EXPIRED)) {
      Caller caller = caller(each, MemberRole.OBSERVER, "otto");
      OfService drive = seen(policy, caller, "drive", PolicyVisibility.STOPPABLE);
      assertThat(drive.isShown()).isTrue();
      assertThat(drive.isShown(MODULE, "robot")).isTrue();
      assertThat(drive.isShown(MODULE, "name")).isTrue();
      assertThat(drive.isShown(MODULE, "host")).isFalse();
      assertThat(seen(policy, caller, "gps", GPS).isShown()).isFalse();
    }
    assertThat(seen(policy, STRANGER, "drive", PolicyVisibility.STOPPABLE).isShown()).isFalse();
    Caller own = caller(Standing.OWN, MemberRole.ROBOT, "atrv1");
    assertThat(new PolicyGuard(policy).visibility(own)).isSameAs(Visibility.ALL);
  }

  @Test
  void attributesOfOtherClassesAreNamedInFull() {
    String lms = "org.dfra.drivers.laser.lms.LmsAttributes";
    Policy policy =
        policy(
            "<show standing=\"stranger\" entry=\"" + lms + ".type\"/>",
            "<hide standing=\"stranger\" entry=\"" + lms + "\"/>");
    OfService laser = seen(policy, STRANGER, "laser", GPS);
    assertThat(laser.isShown(lms, "type")).isTrue();
    assertThat(laser.isShown(lms, "baud")).isFalse();
    assertThat(laser.isShown(lms)).as("a component that is shown does not show all").isFalse();
  }

  @Test
  void faultsNameFileAndLine() {
    assertThatThrownBy(
            () ->
                policy(
                    "<hide entry=\"modul.host\"/>",
                    "<hide entry=\"module.hots\"/>",
                    "<hide standing=\"own\"/>",
                    "<hide type=\"GPSSensr\"/>",
                    "<hide entry=\" , \"/>",
                    "<hide object=\"a b\"/>",
                    "<hide interface=\"GPSSensor\"/>"))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContainingAll(
            "p.xml:2: there are no attributes \"modul\"; did you mean \"module\"?",
            "p.xml:3: the attributes module have no component \"hots\"; did you mean \"host\"?",
            "p.xml:4: nothing is hidden from a robot's own processes; delete own from standing",
            "p.xml:5: there is no remote interface \"GPSSensr\"; did you mean \"GPSSensor\"?",
            "p.xml:6: entry names nothing; delete it, or write *",
            "p.xml:7: object: \"a b\" is no name",
            "p.xml:8: ");
    String[] many = new String[PolicyXml.MAX_VISIBILITY_RULES + 1];
    Arrays.fill(many, "<hide/>");
    assertThatThrownBy(() -> policy(many))
        .hasMessageContaining("the policy has 65 <hide> and <show>, at most 64 are read");
  }

  @Test
  void theTableOfRecordsIsComplete() {
    Map<String, List<String>> actual = new HashMap<>();
    Function<Class<? extends Attributes>, List<String>> components =
        type -> Arrays.stream(type.getRecordComponents()).map(RecordComponent::getName).toList();
    QueryTypeNames.standard()
        .attributes()
        .forEach(type -> actual.put(type.getName(), components.apply(type)));
    actual.put(PersonaAttributes.class.getName(), components.apply(PersonaAttributes.class));
    assertThat(EntryPattern.records()).containsExactlyInAnyOrderEntriesOf(actual);
  }

  @Test
  void namesAreWrittenAsInQueries() {
    for (String each : List.of("emergency_stop.latched", "EmergencyStop.Latched")) {
      assertThat(EntryPattern.of(each))
          .isEqualTo(new EntryPattern("org.dfra.persona.EmergencyStopAttributes", "latched"));
    }
    assertThat(EntryPattern.of("sensor.max_rate").toString()).isEqualTo("sensor.maxRate");
    assertThat(EntryPattern.of("org.dfra.persona.GpsReceiverAttributes.model").toString())
        .isEqualTo("gps_receiver.model");
    assertThat(EntryPattern.of("module.*")).isEqualTo(EntryPattern.of("module"));
  }
}
