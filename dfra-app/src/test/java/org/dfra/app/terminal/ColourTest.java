package org.dfra.app.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ColourTest {

  @Test
  void statesAreColouredAndWordsThatContainThemAreNot() {
    assertThat(Colour.of("gps  READY   1")).isEqualTo("gps  \u001b[32mREADY\u001b[0m   1");
    assertThat(Colour.of("0.5 s  MISSED")).isEqualTo("0.5 s  \u001b[31mMISSED\u001b[0m");
    assertThat(Colour.of("FAILED while it ends")).startsWith("\u001b[31mFAILED\u001b[0m while");
    assertThat(Colour.of("an already_ready module")).isEqualTo("an already_ready module");
  }

  @Test
  void thereIsNoneInAPipeNorWhereSomebodyWantsNone() {
    assertThat(Colour.isWanted(true, null, "xterm-256color")).isTrue();
    assertThat(Colour.isWanted(true, "", "xterm")).isTrue();
    assertThat(Colour.isWanted(false, null, "xterm")).as("a pipe").isFalse();
    assertThat(Colour.isWanted(true, "1", "xterm")).as("NO_COLOR").isFalse();
    assertThat(Colour.isWanted(true, null, "dumb")).isFalse();
  }

  @Test
  void theNameOfAValueIsNoState() {
    assertThat(Colour.of("stale: no")).isEqualTo("stale: no");
    assertThat(Colour.of("stale, 2 s ago")).contains("\u001b[31mstale");
  }
}
