package org.dfra.core.robot;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Closes related resources. A failure to close one does not prevent closing the others; all
 * failures are reported together afterwards.
 *
 * <p>Thread-safe.
 */
public final class ResourceCloser {

  private final String whose;

  @GuardedBy("this")
  private final List<Throwable> failures = new ArrayList<>();

  /**
   * @param owner the owner of the resources, for the message, e.g. {@code robot atrv1}
   */
  public ResourceCloser(String owner) {
    this.whose = owner;
  }

  /** Closes one resource. */
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

  /** Adds the failures to an earlier exception as suppressed ones. */
  public synchronized void addSuppressedTo(Throwable before) {
    failures.forEach(before::addSuppressed);
  }

  /**
   * Throws if a resource could not be closed.
   *
   * @throws IOException whose message names each failure; they are its suppressed exceptions
   */
  public void throwIfFailed() throws IOException {
    throwIfFailed(IOException::new);
  }

  /**
   * The same, as another exception.
   *
   * @param made creates it from its message
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
