package org.dfra.attack.answer;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.UUID;
import net.jini.core.lease.Lease;
import net.jini.lease.LeaseRenewalManager;
import org.dfra.app.InProcessCommand;
import org.dfra.benchmarks.attack.HostileModule;
import org.dfra.benchmarks.attack.TerminalCheck;
import org.dfra.persona.Attributes;
import org.dfra.report.terminal.ExitCode;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.text.PrintableText;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A stranger registers a module all of whose texts are hostile. No command lets it control the
 * operator's terminal or begin a line with what it wants the operator to read.
 */
@Timeout(180)
class ForgedOutputTest {

  private static final String ROBOT = PrintableText.word(HostileModule.NAME);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir static Path folder;

  private static final LeaseRenewalManager RENEWAL = new LeaseRenewalManager();

  @BeforeAll
  static void attack() throws Exception {
    register(HostileModule.proxy(), HostileModule.attributes());
    register("a registrar", List.of(HostileModule.persona()));
  }

  private static void register(Object service, List<? extends Attributes> attributes)
      throws Exception {
    Lease lease =
        REGGIE
            .register(UUID.randomUUID(), service, attributes, EmbeddedReggie.LEASE_MILLIS)
            .getLease();
    RENEWAL.renewUntil(lease, Lease.FOREVER, null);
  }

  @AfterAll
  static void end() {
    RENEWAL.clear();
  }

  private static InProcessCommand run(String... words) {
    List<String> all = new ArrayList<>(Arrays.asList(words));
    all.add("--wait=10");
    return InProcessCommand.at(REGGIE, folder.resolve("state"), all);
  }

  private static void assertHarmless(String text) {
    assertThat(text)
        .as("characters that control a terminal")
        .doesNotContainPattern(TerminalCheck.CONTROL);
    assertThat(text.lines())
        .as("lines that begin with forged text")
        .noneMatch(line -> line.startsWith(HostileModule.FORGED));
  }

  private static void assertHarmless(InProcessCommand output) {
    assertHarmless(output.out());
    assertHarmless(output.err());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "module list",
        "module list --json",
        "persona list",
        "persona list --json",
        "lease list",
        "doctor",
        "doctor --json",
        "stop --all --json"
      })
  void noCommandLetsItControlTheTerminalOrBeginALine(String command) {
    InProcessCommand output = run(command.split(" "));
    assertHarmless(output);
    assertThat(output.out()).as("it is shown all the same").contains("\\u009b2");
  }

  @Test
  void aForgedStopIsShownInTheLineOfTheModuleThatClaimsIt() {
    InProcessCommand output = run("stop", "--all");
    assertHarmless(output);
    assertThat(output.out()).startsWith("2\\u0020effectors:\\u00202\\u0020stopped.\\u009b2K");
    assertThat(output.out().lines().reduce((first, last) -> last).orElseThrow())
        .startsWith("1 effector: 1 DRIVER NOT STOPPED");
    assertThat(output.code()).isEqualTo(ExitCode.FAILED);
  }

  /** What they show of one that is named is not the same in each; none of it is raw. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "module info",
        "module get",
        "module diagnose",
        "module recover",
        "module call driveState",
        "log level",
        "lease list",
        "persona show"
      })
  void norDoesOneThatIsAskedAboutIt(String command) {
    List<String> words = new ArrayList<>(Arrays.asList(command.split(" ")));
    words.add(2, command.startsWith("persona") ? ROBOT : ROBOT + "/" + ROBOT);
    InProcessCommand output = run(words.toArray(String[]::new));
    assertHarmless(output);
    assertThat(output.out() + output.err()).contains("\\u009b2");
  }
}
