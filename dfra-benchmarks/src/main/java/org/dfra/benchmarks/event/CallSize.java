package org.dfra.benchmarks.event;

import java.io.IOException;
import java.lang.reflect.Method;
import java.time.Instant;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Reading;
import org.dfra.river.remote.RemoteModuleListener;

/** The number of bytes of the calls that deliver events. */
public final class CallSize {

  /** The object's ID and the header of a block, which the transport adds. */
  private static final int TRANSPORT = 16 + 4;

  private CallSize() {}

  /** Bytes of the call that delivers an event of a {@link BenchSensor}. */
  static int ofEvent() throws IOException {
    return of(BenchSensor.fix(Instant.now()));
  }

  /**
   * Bytes of the call that delivers a reading to one remote listener.
   *
   * @throws IOException if the reading cannot be written
   */
  public static int of(Reading reading) throws IOException {
    Delivery delivery = new Delivery("bench/gps", 1, 1, 0, Instant.now(), new NewReading(reading));
    return TRANSPORT + CallBytes.of(notifyMethod(), delivery, 1L, 1L).length;
  }

  /** The method that delivers one event. */
  public static Method notifyMethod() {
    try {
      return RemoteModuleListener.class.getMethod("notify", Delivery.class, long.class, long.class);
    } catch (NoSuchMethodException e) {
      throw new IllegalStateException(e);
    }
  }
}
