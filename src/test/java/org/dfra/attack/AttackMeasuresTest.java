package org.dfra.attack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import org.dfra.app.bench.attack.BombServer;
import org.dfra.app.bench.attack.FigureLines;
import org.dfra.app.bench.attack.FileLocks;
import org.dfra.app.bench.attack.HostileModule;
import org.dfra.app.bench.attack.TerminalCheck;
import org.dfra.app.figure.Figure;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What attacks are measured by sees harm where there is some. */
class AttackMeasuresTest {

  @TempDir Path temp;

  @Test
  void figuresCrossTheLineBetweenTwoProcesses() {
    List<Figure> figures =
        List.of(
            new Figure("locks held by the attacker", 1, 0, ""),
            new Figure("CPU until nested XML is refused", 0.25, 1, "s"),
            new Figure("bombs thrown", 7, Double.POSITIVE_INFINITY, ""));
    List<String> lines =
        List.of(
            "begins",
            FigureLines.write(figures.get(0)),
            FigureLines.write(figures.get(1)),
            FigureLines.write(figures.get(2)),
            "done 7 7 null");
    assertThat(FigureLines.read(lines)).isEqualTo(figures);
    assertThatThrownBy(() -> FigureLines.read(List.of("figure 1 2 s")))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("figure 1 2 s");
  }

  @Test
  void charactersThatControlATerminalAreCountedByTheLine() {
    TerminalCheck check = new TerminalCheck();
    check.add("atrv1/drive  READY\nx\\u009b2J shown, and harmless\n");
    assertThat(check.figures()).allMatch(Figure::isMet);
    assertThat(check.shows("\\u009b2")).isTrue();
    assertThat(check.shows("\\u009b7")).isFalse();

    check.add("an escape \u001b[2J, and again \u001b[2J\n" + "a C1 control \u009b2J\n");
    check.add("reversed \u202e\n" + HostileModule.FORGED + "\n" + HostileModule.TEXT);
    assertThat(measured(check, "output lines with control characters")).isEqualTo(4);
    assertThat(measured(check, "output lines that begin with forged text")).isEqualTo(2);
  }

  private static double measured(TerminalCheck check, String what) {
    return check.figures().stream()
        .filter(each -> each.what().equals(what))
        .mapToDouble(Figure::measured)
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
