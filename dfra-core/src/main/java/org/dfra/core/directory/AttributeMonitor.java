package org.dfra.core.directory;

import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.persona.Attributes;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Publishes a module's attributes whenever they change.
 *
 * <p>It polls every {@value #POLL_MILLIS} ms. So drivers need not report changes, and a driver with
 * frequent changes cannot flood a lookup service.
 *
 * <p>Threads: one daemon, {@code dfra-attributes}, polls all modules of a virtual machine; in
 * lock-step the scheduler polls.
 */
public final class AttributeMonitor implements DirectoryRegistration {

  /** The polling period in milliseconds. */
  public static final long POLL_MILLIS = 500;

  private static final Logger LOG = LoggerFactory.getLogger(AttributeMonitor.class);

  private static final ScheduledExecutorService LOOKER =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "dfra-attributes");
            thread.setDaemon(true);
            return thread;
          });

  private final Supplier<List<Attributes>> attributes;
  private final Consumer<List<Attributes>> publisher;
  private volatile ScheduledTask looking = () -> {}; // set when it starts
  private volatile boolean closed;
  private List<Attributes> published; // used by the polling thread only

  private AttributeMonitor(
      List<Attributes> published,
      Supplier<List<Attributes>> attributes,
      Consumer<List<Attributes>> publisher) {
    this.published = List.copyOf(published);
    this.attributes = attributes;
    this.publisher = publisher;
  }

  /**
   * Starts to poll, in real time.
   *
   * @param published the attributes published already
   * @param attributes returns its current attributes
   * @param publisher receives the changed attributes; it must not block
   */
  public static AttributeMonitor start(
      List<Attributes> published,
      Supplier<List<Attributes>> attributes,
      Consumer<List<Attributes>> publisher) {
    return start(published, attributes, publisher, Scheduler.system());
  }

  /** The same, on {@code scheduler} if that is in lock-step, in real time otherwise. */
  public static AttributeMonitor start(
      List<Attributes> published,
      Supplier<List<Attributes>> attributes,
      Consumer<List<Attributes>> publisher,
      Scheduler scheduler) {
    AttributeMonitor monitor = new AttributeMonitor(published, attributes, publisher);
    if (scheduler.isLockStep()) {
      monitor.looking = monitor.later(scheduler);
    } else {
      Future<?> future =
          LOOKER.scheduleWithFixedDelay(
              monitor::look, POLL_MILLIS, POLL_MILLIS, TimeUnit.MILLISECONDS);
      monitor.looking = () -> future.cancel(false);
    }
    return monitor;
  }

  private ScheduledTask later(Scheduler scheduler) {
    return scheduler.after(
        TimeUnit.MILLISECONDS.toNanos(POLL_MILLIS),
        () -> {
          if (!closed) {
            look();
            looking = later(scheduler);
          }
        });
  }

  private void look() {
    try {
      List<Attributes> now = attributes.get();
      if (!now.equals(published)) {
        published = List.copyOf(now);
        publisher.accept(published);
      }
    } catch (RuntimeException e) {
      LOG.warn("A module's attributes cannot be published: {}", e.toString(), e);
    }
  }

  @Override
  public void close() {
    closed = true;
    looking.cancel();
  }
}
