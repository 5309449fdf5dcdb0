package org.dfra.cli.audit;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Waits for changes of files in a folder. While this is open, a shutdown hook ends the wait when
 * the process receives a signal to terminate, such as by Ctrl-C, and delays the exit until {@link
 * #close}, so that no line is printed in part.
 */
final class FolderWatch implements Closeable {

  /** How often the caller may check that its output is still open. */
  private static final Duration TICK = Duration.ofSeconds(1);

  private static final Duration EXIT_TIMEOUT = Duration.ofSeconds(2);

  private final WatchService service;
  private final CountDownLatch closed = new CountDownLatch(1);
  private final Thread hook = new Thread(this::terminate, "dfra-audit-end");

  private FolderWatch(WatchService service) {
    this.service = service;
  }

  static FolderWatch open(Path folder) throws IOException {
    WatchService service = folder.getFileSystem().newWatchService();
    try {
      WatchKey unused =
          folder.register(
              service,
              StandardWatchEventKinds.ENTRY_CREATE,
              StandardWatchEventKinds.ENTRY_MODIFY,
              StandardWatchEventKinds.ENTRY_DELETE);
    } catch (IOException e) {
      service.close();
      throw e;
    }
    FolderWatch watch = new FolderWatch(service);
    Runtime.getRuntime().addShutdownHook(watch.hook);
    return watch;
  }

  /**
   * Waits for a change, or for a second.
   *
   * @return false if the process is terminating or the folder was removed
   */
  boolean await() throws InterruptedException {
    try {
      @Nullable WatchKey key = service.poll(TICK.toMillis(), TimeUnit.MILLISECONDS);
      if (key == null) {
        return true;
      }
      key.pollEvents(); // which files changed is found by reading
      return key.reset();
    } catch (ClosedWatchServiceException e) {
      return false; // terminate has closed it
    }
  }

  private void terminate() {
    try {
      service.close();
      boolean unused = closed.await(EXIT_TIMEOUT.toNanos(), TimeUnit.NANOSECONDS);
    } catch (IOException e) {
      closed.countDown(); // the process ends now, at whatever line
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void close() throws IOException {
    closed.countDown();
    service.close();
    try {
      boolean unused = Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // the JVM is shutting down already, and the hook need not wait
      assert closed.getCount() == 0;
    }
  }
}
