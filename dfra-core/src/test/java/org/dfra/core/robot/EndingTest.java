package org.dfra.core.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class EndingTest {

  private final Ending ending = new Ending("robot atrv1");
  private final List<String> ended = new ArrayList<>();

  private AutoCloseable jammed(Exception why) {
    return () -> {
      throw why;
    };
  }

  @Test
  void endsTheOthersAndNamesEachThatCouldNotBe() {
    IOException jam = new IOException("the laser is jammed");
    NullPointerException bug = new NullPointerException();
    ending.end(() -> ended.add("camera"));
    ending.end(jammed(jam));
    ending.end(jammed(bug));
    ending.end(() -> ended.add("drive"));
    assertThat(ended).containsExactly("camera", "drive");
    assertThatThrownBy(ending::orThrow)
        .isInstanceOf(IOException.class)
        .hasMessage(
            "robot atrv1 did not end cleanly: the laser is jammed; java.lang.NullPointerException")
        .satisfies(thrown -> assertThat(thrown.getSuppressed()).containsExactly(jam, bug));
    assertThatThrownBy(() -> ending.orThrow(IllegalStateException::new))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("the laser is jammed");
  }

  @Test
  void saysNothingWhereAllEnded() {
    ending.end(() -> ended.add("camera"));
    assertThatCode(ending::orThrow).doesNotThrowAnyException();
    IOException before = new IOException("it did not start");
    ending.addTo(before);
    assertThat(before.getSuppressed()).isEmpty();
  }

  @Test
  void keepsAnInterruption() {
    ending.end(jammed(new InterruptedException("stop")));
    assertThat(Thread.interrupted()).isTrue();
    assertThatThrownBy(ending::orThrow).hasMessageEndingWith("cleanly: stop");
  }
}
