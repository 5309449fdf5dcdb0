package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.dfra.report.terminal.Terminal.Size;
import org.junit.jupiter.api.Test;

/** What is drawn is judged by what a {@link Screen} shows of it. */
class LiveBlockTest {

  private static final String END = System.lineSeparator();

  private Size size = new Size(20, 10);
  private final LiveBlock block = new LiveBlock(() -> size);
  private final Screen screen = new Screen();

  @Test
  void isDrawnInPlace() {
    screen.print(block.draw(List.of("one", "two", "three")));
    screen.print(block.draw(List.of("four", "five")));
    assertThat(screen.lines()).containsExactly("four", "five");
  }

  @Test
  void textScrollsAboveItUnharmed() {
    screen.print(block.printAbove("before" + END));
    screen.print(block.draw(List.of("one", "two")));
    screen.print(block.printAbove("said" + END + "in two lines" + END));
    assertThat(screen.lines()).containsExactly("before", "said", "in two lines", "one", "two");
    screen.print(block.draw(List.of("three", "four")));
    screen.print(block.printAbove("said again" + END));
    assertThat(screen.lines())
        .containsExactly("before", "said", "in two lines", "said again", "three", "four");
  }

  @Test
  void whatIsLeftStays() {
    screen.print(block.draw(List.of("one")));
    assertThat(block.isDrawn()).isTrue();
    block.freeze();
    assertThat(block.isDrawn()).isFalse();
    screen.print(block.printAbove("below" + END));
    screen.print(block.draw(List.of("two")));
    screen.print(block.draw(List.of("three")));
    assertThat(screen.lines()).containsExactly("one", "below", "three");
  }

  @Test
  void isCutToTheTerminalAndFollowsItsSize() {
    screen.print(block.draw(List.of("a line of exactly 20", "a line with 21 in all")));
    assertThat(screen.lines()).containsExactly("a line of exactly 20", "a line with 21 in a…");
    size = new Size(8, 10);
    screen.narrow(8);
    screen.print(block.printAbove("no matter how wide what is said is" + END));
    assertThat(screen.lines())
        .containsExactly("no matter how wide what is said is", "a line …", "a line …");
  }

  @Test
  void isNoHigherThanTheTerminal() {
    size = new Size(20, 4); // the cursor has a line of its own
    List<String> tall = IntStream.range(0, 9).mapToObj(each -> "line " + each).toList();
    screen.print(block.draw(tall));
    screen.print(block.draw(tall));
    assertThat(screen.lines()).containsExactly("line 0", "line 1", "line 2");
  }

  @Test
  void leavesTheTerminalAsItWasAfterEachPiece() {
    for (String piece :
        List.of(
            block.draw(List.of("one")),
            block.printAbove("said" + END),
            block.draw(List.of("two")))) {
      assertThat(piece).endsWith("\u001b[?7h").doesNotContain("\u001b[?25");
      assertThat(piece.split("\u001b\\[\\?7l", -1)).as("turned off once").hasSize(2);
    }
    assertThat(block.draw(List.of())).as("nothing to draw").doesNotContain("\u001b[?7l");
  }

  @Test
  void anEllipsisIsOneOfTheColumns() {
    assertThat(LiveBlock.cut("22 µs at 5 °C", 13)).isEqualTo("22 µs at 5 °C");
    assertThat(LiveBlock.cut("22 µs at 5 °C", 12)).isEqualTo("22 µs at 5 …");
    assertThat(LiveBlock.cut("a 🚁 flies", 4)).isEqualTo("a 🚁…");
    assertThat(LiveBlock.cut("blanks at the end   ", 17)).isEqualTo("blanks at the end");
    assertThat(LiveBlock.cut("ab", 1)).isEqualTo("…");
  }

  /** As most terminals do: what does not fit any more goes on in the next row. */
  @Test
  void leavesNoGhostsWhereTheTerminalWasMadeNarrower() {
    String first = block.draw(List.of("a line of exactly 20", "short"));
    assertThat(first).contains("a line of exactly 20");
    size = new Size(8, 10);
    assertThat(block.draw(List.of("one"))).as("3 rows and 1").startsWith("\u001b[4A\u001b[J");
    assertThat(block.draw(List.of("two"))).startsWith("\u001b[1A\u001b[J");
  }
}
