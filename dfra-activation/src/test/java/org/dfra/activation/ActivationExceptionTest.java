package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ActivationExceptionTest {

  private final IOException nested = new IOException("no route");

  @Test
  void messageIncludesTheNestedFailure() {
    assertThat(new ActivationException("cannot start", nested))
        .hasMessage("cannot start; nested exception is: \n\tjava.io.IOException: no route")
        .hasCause(nested);
    assertThat(new ActivationException("cannot start")).hasMessage("cannot start").hasNoCause();
    assertThat(new ActivationException()).hasMessage(null).hasNoCause();
  }

  @Test
  void causeIsWhateverThePublicFieldHolds() {
    ActivationException e = new ActivationException("cannot start");
    e.detail = nested;

    assertThat(e.getCause()).isSameAs(nested);
    assertThat(e).hasMessageContaining("no route");
  }

  static Stream<ActivationException> every() {
    return Stream.of(
        new ActivationException(),
        new ActivationException("m"),
        new ActivationException("m", new IOException()),
        new ActivationException("m", null),
        new UnknownObjectException("m"),
        new UnknownGroupException("m"));
  }

  @ParameterizedTest
  @MethodSource("every")
  void causeCannotBeInitialisedAfterwards(ActivationException e) {
    assertThatIllegalStateException().isThrownBy(() -> e.initCause(new IOException()));
  }

  @Test
  void nestedFailureCrossesTheWire() throws Exception {
    ActivationException read =
        (ActivationException) Streams.roundTrip(new ActivationException("cannot start", nested));

    assertThat(read).hasMessageContaining("no route").hasCauseInstanceOf(IOException.class);
  }

  @Test
  void failedActivationIsARemoteException() {
    assertThat(new ActivateFailedException("asleep").detail).isNull();
    assertThat(new ActivateFailedException("asleep", nested).detail).isSameAs(nested);
  }
}
