package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import org.junit.jupiter.api.Test;

/** A client may send what reggie writes to its log, and build it as it likes. */
class QueuedEventListenerTest {

  /** A listener that is copied. */
  private static final class Copied implements RemoteEventListener, Serializable {

    private static final long serialVersionUID = 1L;

    @Override
    public void notify(RemoteEvent event) {
      throw new AssertionError("nothing is to be reported: " + event);
    }
  }

  private static QueuedEventListener of(RemoteEventListener listener) {
    return new QueuedEventListener(listener, "192.0.2.7", null, listener, Runnable::run);
  }

  private static Object copy(QueuedEventListener listener)
      throws IOException, ClassNotFoundException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(listener);
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      return in.readObject();
    }
  }

  @Test
  void isReadWithWhatCameFromTheClient() throws Exception {
    assertThat(copy(of(new Copied())))
        .isInstanceOfSatisfying(
            QueuedEventListener.class,
            read -> {
              assertThat(read.client()).isEqualTo("192.0.2.7");
              assertThat(read.listener()).isInstanceOf(Copied.class);
            });
  }

  @Test
  void isNotReadWhereItHoldsAnother() {
    QueuedEventListener nested = of(of(new Copied()));
    assertThatThrownBy(() -> copy(nested)).isInstanceOf(InvalidObjectException.class);
  }
}
