package org.dfra.attack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import org.dfra.benchmarks.attack.BombServer;
import org.dfra.benchmarks.attack.FileLocks;
import org.dfra.benchmarks.attack.HostileModule;
import org.dfra.benchmarks.attack.MeasuredValueLines;
import org.dfra.benchmarks.attack.TerminalCheck;
import org.dfra.report.measurement.MeasuredValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What attacks are measured by sees harm where there is some. */
class AttackMeasuresTest {

  @TempDir Path temp;

  @Test
  void figuresCrossTheLineBetweenTwoProcesses() {
    List<MeasuredValue> figures =
        List.of(
            new MeasuredValue("locks held by the attacker", 1, 0, ""),
            new MeasuredValue("CPU until nested XML is refused", 0.25, 1, "s"),
            new MeasuredValue("bombs thrown", 7, Double.POSITIVE_INFINITY, ""));
    List<String> lines =
        List.of(
            "begins",
            MeasuredValueLines.write(figures.get(0)),
            MeasuredValueLines.write(figures.get(1)),
            MeasuredValueLines.write(figures.get(2)),
            "done 7 7 null");
    assertThat(MeasuredValueLines.read(lines)).isEqualTo(figures);
    assertThatThrownBy(() -> MeasuredValueLines.read(List.of("figure 1 2 s")))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("figure 1 2 s");
  }

  @Test
  void charactersThatControlATerminalAreCountedByTheLine() {
    TerminalCheck check = new TerminalCheck();
    check.add("atrv1/drive  READY\nx\\u009b2J shown, and harmless\n");
    assertThat(check.figures()).allMatch(MeasuredValue::isMet);
    assertThat(check.shows("\\u009b2")).isTrue();
    assertThat(check.shows("\\u009b7")).isFalse();

    check.add("an escape \u001b[2J, and again \u001b[2J\n" + "a C1 control \u009b2J\n");
    check.add("reversed \u202e\n" + HostileModule.FORGED + "\n" + HostileModule.TEXT);
    assertThat(measured(check, "output lines with control characters")).isEqualTo(4);
    assertThat(measured(check, "output lines that begin with forged text")).isEqualTo(2);
  }

  private static double measured(TerminalCheck check, String what) {
    return check.figures().stream()
        .filter(each -> each.name().equals(what))
        .mapToDouble(MeasuredValue::value)
        .sum();
  }

  @Test
  void aLockThatCanBeTakenIsCountedOnce() throws Exception {
    FileLocks locks = new FileLocks();
    Path file = Files.writeString(temp.resolve("some.lock"), "");
    assertThat(locks.take(file)).isTrue();
    assertThat(locks.take(file)).isTrue();
    assertThat(locks.count()).isEqualTo(1);
    assertThatThrownBy(() -> locks.take(temp.resolve("none.lock")))
        .isInstanceOf(NoSuchFileException.class);
    assertThat(locks.count()).isEqualTo(1);
  }

  @Test
  void bombsAreSmall() throws Exception {
    assertThat(BombServer.claimOfGroups()).hasSizeLessThan(300);
    assertThat(BombServer.claimOfNumbers()).hasSizeLessThan(300);
  }
}
