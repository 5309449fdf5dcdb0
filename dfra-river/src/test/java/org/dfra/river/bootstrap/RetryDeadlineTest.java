package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.EOFException;
import java.net.BindException;
import java.net.SocketException;
import java.rmi.ConnectException;
import java.rmi.MarshalException;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** A command's questions on a computer that is busy; its clock is stepped here. */
class RetryDeadlineTest {

  private final AtomicLong nanos = new AtomicLong(Long.MAX_VALUE - 1_000); // it overflows soon
  private final AtomicInteger asked = new AtomicInteger();
  private final RetryDeadline patience =
      new RetryDeadline(
          Duration.ofSeconds(10),
          nanos::get,
          () -> nanos.addAndGet(Duration.ofSeconds(2).toNanos()));

  @Test
  void asksAgainWhereNoAnswerCame() throws Exception {
    String answer =
        patience.call(
            () -> {
              if (asked.incrementAndGet() < 4) {
                throw new ConnectException("nobody there");
              }
              return "here";
            });
    assertThat(answer).isEqualTo("here");
    assertThat(asked).hasValue(4);
  }

  @Test
  void asksAgainWhereSomebodyElseGotNoAnswer() throws Exception {
    patience.run(
        () -> {
          if (asked.incrementAndGet() == 1) {
            throw new ActivationException("2 attempts", new ConnectException("nobody there"));
          }
        });
    assertThat(asked).hasValue(2);
  }

  @Test
  void givesUpWhenTheCommandsTimeIsOver() {
    assertThatThrownBy(
            () ->
                patience.call(
                    () -> {
                      asked.incrementAndGet();
                      throw new ConnectException("nobody there");
                    }))
        .isInstanceOf(NoAnswerException.class)
        .hasMessage(
            "phoenix, or what it has started, did not answer within 10 s (nobody there); see"
                + " whether its process hangs or the computer is overloaded: ./dfra doctor")
        .hasRootCauseInstanceOf(ConnectException.class);
    assertThat(asked).as("once, and after each of five pauses of 2 s").hasValue(6);
    assertThat(patience.isExpired()).isTrue();
  }

  @Test
  void asksAgainWhereTheConnectionEndedBeforeTheAnswer() throws Exception {
    patience.run(
        () -> {
          switch (asked.incrementAndGet()) {
            case 1 -> throw new UnmarshalException("cut off", new EOFException());
            case 2 -> throw new MarshalException("cut off", new SocketException("Broken pipe"));
            default -> {}
          }
        });
    assertThat(asked).hasValue(3);
  }

  @Test
  void anAnswerThatCannotBeReadIsAnAnswer() {
    assertThatThrownBy(
            () ->
                patience.run(
                    () -> {
                      asked.incrementAndGet();
                      throw new UnmarshalException("unknown", new ClassNotFoundException("a.B"));
                    }))
        .isInstanceOf(UnmarshalException.class);
    assertThat(asked).hasValue(1);
  }

  @Test
  void aRefusalIsAnAnswer() {
    assertThatThrownBy(
            () ->
                patience.run(
                    () -> {
                      asked.incrementAndGet();
                      throw new BindException("port 4160 is taken");
                    }))
        .isInstanceOf(BindException.class);
    assertThat(asked).hasValue(1);
  }
}
