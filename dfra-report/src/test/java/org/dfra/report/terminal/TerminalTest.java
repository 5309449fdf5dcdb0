package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.report.terminal.Terminal.Size;
import org.junit.jupiter.api.Test;

/** A terminal's size is what stty says, as long as that says one. */
class TerminalTest {

  private final AtomicLong nanos = new AtomicLong();
  private final AtomicReference<String> answer = new AtomicReference<>("");
  private final Terminal terminal = new Terminal(nanos::get, answer::get);

  @Test
  void rowsComeFirst() {
    assertThat(Size.read("24 80\n")).contains(new Size(80, 24));
    assertThat(Size.read("50 132")).contains(new Size(132, 50));
  }

  @Test
  void whatIsNoSizeIsNone() {
    assertThat(Size.read("")).isEmpty();
    assertThat(Size.read("0 0\n")).as("a terminal whose size was never set").isEmpty();
    assertThat(Size.read("24 0\n")).isEmpty();
    assertThat(Size.read("stty: standard input: not a tty")).isEmpty();
    assertThatThrownBy(() -> new Size(0, 24)).hasMessageContaining("0 columns and 24 rows");
  }

  @Test
  void isUsualWhereNobodySays() {
    assertThat(terminal.get()).isEqualTo(Size.DEFAULT);
  }

  @Test
  void isAskedForAgainNowAndThen() {
    answer.set("24 100");
    assertThat(terminal.get().columns()).isEqualTo(100);
    answer.set("24 60");
    nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(150));
    assertThat(terminal.get().columns()).as("not yet").isEqualTo(100);
    nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(1));
    assertThat(terminal.get().columns()).isEqualTo(60);
    answer.set("");
    nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(151));
    assertThat(terminal.get().columns()).as("no answer this time").isEqualTo(60);
  }

  @Test
  void aTableIsAsWideAsColumnsSaysOrTheTerminal() {
    assertThat(Terminal.columns("132", () -> new Size(70, 24))).isEqualTo(132);
    assertThat(Terminal.columns("", () -> new Size(70, 24))).isEqualTo(70);
    assertThat(Terminal.columns("-3", () -> Size.DEFAULT)).isEqualTo(80);
    assertThat(Terminal.columns(null, () -> Size.DEFAULT)).isEqualTo(80);
  }
}
