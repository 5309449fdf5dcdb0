package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class StatusHighlighterTest {

  @Test
  void statesAreColouredAndWordsThatContainThemAreNot() {
    assertThat(StatusHighlighter.highlight("gps  READY   1"))
        .isEqualTo("gps  \u001b[32mREADY\u001b[0m   1");
    assertThat(StatusHighlighter.highlight("0.5 s  MISSED"))
        .isEqualTo("0.5 s  \u001b[31mMISSED\u001b[0m");
    assertThat(StatusHighlighter.highlight("FAILED while it ends"))
        .startsWith("\u001b[31mFAILED\u001b[0m while");
    assertThat(StatusHighlighter.highlight("an already_ready module"))
        .isEqualTo("an already_ready module");
  }

  @Test
  void thereIsNoneInAPipeNorWhereSomebodyWantsNone() {
    assertThat(StatusHighlighter.isEnabled(true, null, "xterm-256color")).isTrue();
    assertThat(StatusHighlighter.isEnabled(true, "", "xterm")).isTrue();
    assertThat(StatusHighlighter.isEnabled(false, null, "xterm")).as("a pipe").isFalse();
    assertThat(StatusHighlighter.isEnabled(true, "1", "xterm")).as("NO_COLOR").isFalse();
    assertThat(StatusHighlighter.isEnabled(true, null, "dumb")).isFalse();
  }

  @Test
  void theNameOfAValueIsNoState() {
    assertThat(StatusHighlighter.highlight("stale: no")).isEqualTo("stale: no");
    assertThat(StatusHighlighter.highlight("stale, 2 s ago")).contains("\u001b[31mstale");
  }
}
