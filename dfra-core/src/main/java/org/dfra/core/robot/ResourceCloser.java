package org.dfra.core.robot;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The end of things that belong together. One that cannot be ended does not keep the others from
 * ending; whoever asked learns afterwards of each, and why.
 *
 * <p>Safe for use by any threads.
 */
public final class ResourceCloser {

  private final String whose;
  private final List<Throwable> failures = new ArrayList<>(); // guarded by this

  /**
   * @param owner end it is, for the message, e.g. {@code robot atrv1}
   */
  public ResourceCloser(String owner) {
    this.whose = owner;
  }

  /** Ends one of them now. */
  public void close(AutoCloseable thing) {
    try {
      thing.close();
    } catch (Exception | Error e) { // as AutoCloseable declares it; orThrow reports each
      if (e instanceof InterruptedException) {
        Thread.currentThread().interrupt();
      }
      synchronized (this) {
        failures.add(e);
      }
    }
  }

  /** What could not be ended is added to something that went wrong before. */
  public synchronized void addSuppressedTo(Throwable before) {
    failures.forEach(before::addSuppressed);
  }

  /**
   * Throws where one could not be ended.
   *
   * @throws IOException whose message names each failure; they are its suppressed exceptions
   */
  public void throwIfFailed() throws IOException {
    throwIfFailed(IOException::new);
  }

  /**
   * The same, as another exception.
   *
   * @param made makes it from its message
   */
  public synchronized <X extends Exception> void throwIfFailed(Function<String, X> made) throws X {
    if (failures.isEmpty()) {
      return;
    }
    X failure =
        made.apply(
            failures.stream()
                .map(each -> each.getMessage() == null ? each.toString() : each.getMessage())
                .collect(Collectors.joining("; ", whose + " did not end cleanly: ", "")));
    addSuppressedTo(failure);
    throw failure;
  }
}
