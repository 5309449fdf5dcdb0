package org.dfra.river.access;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import net.jini.jeri.InboundRequest;
import org.dfra.security.AccessRequest;
import org.dfra.security.CallUse;
import org.dfra.security.Guard;
import org.dfra.security.Guard.Measurement;
import org.jspecify.annotations.Nullable;

/**
 * Measures one call for its guard. It is an element of the call's context, where the dispatcher
 * finds it again. Used by the thread that serves the call.
 */
final class MeteredCall {

  private final Guard guard;
  private final @Nullable MeteredRequest bytes;
  private final long processorBegan;
  private @Nullable AccessRequest permitted;

  /** The bean is not initialised before a guard wants processor time. */
  private static final class Processor {
    static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  }

  private MeteredCall(Guard guard, @Nullable MeteredRequest bytes, long processorBegan) {
    this.guard = guard;
    this.bytes = bytes;
    this.processorBegan = processorBegan;
  }

  /** Begins to measure a call; null if its guard does not want to know. */
  static @Nullable MeteredCall begin(Guard guard, InboundRequest request) {
    Measurement wanted = guard.measurement();
    if (wanted == Measurement.NONE) {
      return null;
    }
    return new MeteredCall(
        guard,
        request instanceof MeteredRequest counted ? counted : null,
        wanted == Measurement.BYTES ? -1 : Processor.THREADS.getCurrentThreadCpuTime());
  }

  /** The call is about to run. Of a refused one, nothing is reported. */
  void permitted(AccessRequest request) {
    permitted = request;
  }

  /** Its dispatcher has returned. Reports what it has used when its response was sent. */
  void dispatched() {
    if (bytes == null) {
      end();
    } else {
      bytes.whenEnded(this::end);
    }
  }

  private void end() {
    long all = bytes == null ? 0 : bytes.takeBytes();
    if (permitted != null) {
      long nanos =
          processorBegan < 0 ? 0 : Processor.THREADS.getCurrentThreadCpuTime() - processorBegan;
      guard.ended(permitted, new CallUse(all, Math.max(0, nanos)));
    }
  }
}
