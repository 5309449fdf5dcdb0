package org.dfra.transport;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;

/**
 * An argument or result of a call that pauses in the middle while it is sent, if the sending
 * process wants that.
 */
public final class Halves implements Serializable {

  private static final long serialVersionUID = 1L;

  /** More than buffers keep back: half of it leaves before the pause. */
  private static final int HALF_BYTES = 200_000;

  private static volatile Pause pause = () -> {};

  private final int number;

  Halves(int number) {
    this.number = number;
  }

  int number() {
    return number;
  }

  /** What a process does when it has sent one half. */
  interface Pause {

    /** Returns when the other half may follow. */
    void await() throws IOException;
  }

  /** Sets what this process does in the middle. */
  static void pauseBy(Pause next) {
    pause = next;
  }

  private void writeObject(ObjectOutputStream out) throws IOException {
    out.defaultWriteObject();
    out.write(new byte[HALF_BYTES]);
    out.flush();
    pause.await();
    out.write(new byte[HALF_BYTES]);
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    byte[] bytes = new byte[2 * HALF_BYTES];
    in.readFully(bytes);
    if (bytes[bytes.length - 1] != 0) {
      throw new InvalidObjectException("bytes that nobody has sent");
    }
  }
}
