package org.dfra.core.directory;

import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dfra.directory.Watch;
import org.dfra.persona.Attributes;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.Task;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Tells what a module says of itself whenever that has changed.
 *
 * <p>It looks every {@value #MILLIS} ms rather than being told: so no driver has to remember to
 * tell, and no restless driver can flood a lookup service.
 *
 * <p>Threads: one daemon, {@code dfra-attributes}, looks for all modules of a virtual machine; in
 * lock-step the scheduler looks.
 */
public final class AttributeFollower implements Watch {

  /** Changes are looked for at this distance, in milliseconds. */
  public static final long MILLIS = 500;

  private static final Logger LOG = LoggerFactory.getLogger(AttributeFollower.class);

  private static final ScheduledExecutorService LOOKER =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "dfra-attributes");
            thread.setDaemon(true);
            return thread;
          });

  private final Supplier<List<Attributes>> attributes;
  private final Consumer<List<Attributes>> teller;
  private volatile Task looking;
  private volatile boolean closed;
  private List<Attributes> told; // by the looker

  /**
   * @param told what is known of the module already
   * @param attributes what it says of itself now
   * @param teller takes the news; it must not block
   */
  public AttributeFollower(
      List<Attributes> told,
      Supplier<List<Attributes>> attributes,
      Consumer<List<Attributes>> teller) {
    this(told, attributes, teller, Scheduler.system());
  }

  /** The same, by the time of {@code scheduler} if that is in lock-step, by real time otherwise. */
  public AttributeFollower(
      List<Attributes> told,
      Supplier<List<Attributes>> attributes,
      Consumer<List<Attributes>> teller,
      Scheduler scheduler) {
    this.told = List.copyOf(told);
    this.attributes = attributes;
    this.teller = teller;
    if (scheduler.isLockStep()) {
      this.looking = later(scheduler);
    } else {
      Future<?> future =
          LOOKER.scheduleWithFixedDelay(this::look, MILLIS, MILLIS, TimeUnit.MILLISECONDS);
      this.looking = () -> future.cancel(false);
    }
  }

  private Task later(Scheduler scheduler) {
    return scheduler.after(
        TimeUnit.MILLISECONDS.toNanos(MILLIS),
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
      if (!now.equals(told)) {
        told = List.copyOf(now);
        teller.accept(told);
      }
    } catch (RuntimeException e) {
      LOG.warn("A module's attributes cannot be told: {}", e.toString(), e);
    }
  }

  @Override
  public void close() {
    closed = true;
    looking.cancel();
  }
}
