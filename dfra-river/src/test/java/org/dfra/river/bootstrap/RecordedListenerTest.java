package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ObjectInputStream;
import org.junit.jupiter.api.Test;

/** A listener as commit 5b8faecf wrote it to a lookup service's log, before it was renamed. */
class RecordedListenerTest {

  @Test
  void becomesAListenerThatWaitsForItsPreparation() throws Exception {
    try (ObjectInputStream in =
        new ObjectInputStream(
            RecordedListenerTest.class.getResourceAsStream("recorded-listener.bin"))) {
      QueuedEventListener listener = (QueuedEventListener) in.readObject();
      assertThat(listener.client()).isEqualTo("10.0.0.7");
      assertThat(listener.listener()).asString().contains("127.0.0.1:4711");
    }
  }
}
