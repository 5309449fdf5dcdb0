package org.dfra.core.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ResourceCloserTest {

  private final ResourceCloser ending = new ResourceCloser("robot atrv1");
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
    ending.close(() -> ended.add("camera"));
    ending.close(jammed(jam));
    ending.close(jammed(bug));
    ending.close(() -> ended.add("drive"));
    assertThat(ended).containsExactly("camera", "drive");
    assertThatThrownBy(ending::throwIfFailed)
        .isInstanceOf(IOException.class)
        .hasMessage(
            "robot atrv1 did not end cleanly: the laser is jammed; java.lang.NullPointerException")
        .satisfies(thrown -> assertThat(thrown.getSuppressed()).containsExactly(jam, bug));
    assertThatThrownBy(() -> ending.throwIfFailed(IllegalStateException::new))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("the laser is jammed");
  }

  @Test
  void saysNothingWhereAllEnded() {
    ending.close(() -> ended.add("camera"));
    assertThatCode(ending::throwIfFailed).doesNotThrowAnyException();
    IOException before = new IOException("it did not start");
    ending.addSuppressedTo(before);
    assertThat(before.getSuppressed()).isEmpty();
  }

  @Test
  void keepsAnInterruption() {
    ending.close(jammed(new InterruptedException("stop")));
    assertThat(Thread.interrupted()).isTrue();
    assertThatThrownBy(ending::throwIfFailed).hasMessageEndingWith("cleanly: stop");
  }
}
