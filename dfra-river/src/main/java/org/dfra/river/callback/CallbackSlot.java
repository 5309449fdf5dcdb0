package org.dfra.river.callback;

import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;

/** The resources that this process reserves for one object that it calls back, until closed. */
public final class CallbackSlot implements AutoCloseable {

  private final Executor lane;
  private final Runnable whenClosed;
  private final AtomicBoolean closed = new AtomicBoolean();

  CallbackSlot(Executor lane, Runnable whenClosed) {
    this.lane = lane;
    this.whenClosed = whenClosed;
  }

  /**
   * Runs the calls on the object; it drops none. The submitter bounds the number of waiting calls.
   */
  public Executor lane() {
    return lane;
  }

  /** Releases the slot. Idempotent. */
  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      whenClosed.run();
    }
  }
}
