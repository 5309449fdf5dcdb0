package org.dfra.river.callback;

import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;

/** What one object that is called back has of this process, until it is closed. */
public final class CallbackSlot implements AutoCloseable {

  private final Executor lane;
  private final Runnable whenClosed;
  private final AtomicBoolean closed = new AtomicBoolean();

  CallbackSlot(Executor lane, Runnable whenClosed) {
    this.lane = lane;
    this.whenClosed = whenClosed;
  }

  /** Runs the calls on the object; it drops none. Who submits bounds how many wait. */
  public Executor lane() {
    return lane;
  }

  /** Gives the place to others. Idempotent. */
  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      whenClosed.run();
    }
  }
}
