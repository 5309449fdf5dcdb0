package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupDesc.CommandEnvironment;
import java.util.List;
import java.util.Properties;
import org.junit.jupiter.api.Test;

/** What a group descriptor may make the daemon execute. */
class ExecPolicyTest {

  private static final ExecPolicy STRICT =
      new ExecPolicy(false, List.of("/opt/*/java"), List.of("-Xmx*m"), List.of("robot=atrv1"));

  @Test
  void permitsWhatIsListed() {
    assertPermitted(STRICT, "/opt/jdk/java", "-Xmx64m", "robot", "atrv1");
    assertPermitted(ExecPolicy.DEFAULT, null, "-anything", "any", "thing");
    assertPermitted(ExecPolicy.DEFAULT, ExecPolicy.ownJava(), "-anything", "any", "thing");
  }

  @Test
  void refusesEachOtherCommandOptionAndPropertyByName() {
    assertRefused(
        ExecPolicy.DEFAULT, "/bin/rm", "-x", "a", "b", "command /bin/rm is not permitted");
    assertRefused(STRICT, "/opt/java", "-Xmx1m", "robot", "atrv1", "permittedCommands");
    assertRefused(STRICT, null, "-agentlib:x", "robot", "atrv1", "option -agentlib:x is not");
    assertRefused(STRICT, null, "-Xmx64m", "robot", "atrv2", "property robot=atrv2 is not");
  }

  @Test
  void starInAPatternIsTheOnlySpecialCharacter() {
    ExecPolicy dots = new ExecPolicy(false, List.of("/a.b"), List.of(), List.of());
    assertThatExceptionOfType(ActivationException.class).isThrownBy(() -> dots.check(desc("/aXb")));
  }

  @Test
  void refusesAGroupClassLocationOrDataOfTheCallers() throws Exception {
    for (ActivationGroupDesc each :
        List.of(
            new ActivationGroupDesc("a.Group", null, null, null, null),
            new ActivationGroupDesc(null, "file:/x", null, null, null),
            new ActivationGroupDesc(null, null, new MarshalledObject<>("data"), null, null))) {
      assertThatExceptionOfType(ActivationException.class)
          .isThrownBy(() -> ExecPolicy.DEFAULT.check(each))
          .withMessageContaining("customGroups");
      assertThatCode(() -> new ExecPolicy(true, List.of(), List.of(), List.of()).check(each))
          .doesNotThrowAnyException();
    }
  }

  private static void assertPermitted(
      ExecPolicy policy, String command, String option, String name, String value) {
    assertThatCode(() -> policy.check(desc(command, option, name, value)))
        .doesNotThrowAnyException();
  }

  private static void assertRefused(
      ExecPolicy policy, String command, String option, String name, String value, String words) {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> policy.check(desc(command, option, name, value)))
        .withMessageContaining(words);
  }

  private static ActivationGroupDesc desc(String command) {
    return new ActivationGroupDesc(null, new CommandEnvironment(command, new String[0]));
  }

  private static ActivationGroupDesc desc(
      String command, String option, String name, String value) {
    Properties properties = new Properties();
    properties.setProperty(name, value);
    return new ActivationGroupDesc(
        properties, new CommandEnvironment(command, new String[] {option}));
  }
}
