package org.dfra.core.budget;

import org.dfra.security.Caller;

/** What one remote listener may use, until closed. Thread-safe. */
public final class ListenerShare implements AutoCloseable {

  private final BudgetGuard guard;
  private final Caller caller;
  private final String object;

  ListenerShare(BudgetGuard guard, Caller caller, String object) {
    this.guard = guard;
    this.caller = caller;
    this.object = object;
  }

  Caller caller() {
    return caller;
  }

  String object() {
    return object;
  }

  /** Its priority when a radio's rate is reached. */
  public ListenerPriority priority() {
    return ListenerPriority.of(caller);
  }

  /** Whether what is sent to it must be counted. */
  public boolean isCounted() {
    return guard.isCounting();
  }

  /** Whether a budget of its caller, or of its module, has no bytes left for readings. */
  public boolean isOutOfBytes() {
    return guard.isOutOfBytes(this);
  }

  /**
   * Counts what it got.
   *
   * @param bytes sent and received on the network for it
   * @param thinned readings that it did not get
   */
  public void count(long bytes, long thinned) {
    guard.count(this, bytes, thinned);
  }

  /** Its place is free again. Idempotent. */
  @Override
  public void close() {
    guard.forget(this);
  }
}
