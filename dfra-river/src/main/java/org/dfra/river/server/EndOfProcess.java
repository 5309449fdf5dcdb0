package org.dfra.river.server;

/**
 * Has something closed when its process is told to end. Phoenix ends its groups so, and a device
 * must be put to rest then as after any other end; nor is it a failure that history would count.
 */
final class EndOfProcess implements AutoCloseable {

  private final Thread hook;

  private EndOfProcess(Thread hook) {
    this.hook = hook;
  }

  /**
   * Has it closed, unless this is closed before.
   *
   * @param what what is closed, for the thread's name
   */
  static EndOfProcess closes(String what, Runnable close) {
    Thread hook = new Thread(close, what + " end");
    Runtime.getRuntime().addShutdownHook(hook);
    return new EndOfProcess(hook);
  }

  @Override
  public void close() {
    try {
      boolean unused = Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The process is ending, perhaps by this very thread; nobody can take a hook back now.
    }
  }
}
