package org.dfra.core.audit;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.dfra.core.audit.AuditIntake.Item;
import org.dfra.core.audit.AuditIntake.Queued;
import org.dfra.core.audit.AuditIntake.Request;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Takes records from the queue and appends them. One daemon thread runs it, which {@link
 * AuditTrail} starts; it ends after {@link #stop}, when the queue is empty.
 */
final class AuditWriter implements Runnable {

  private static final Logger LOG = LoggerFactory.getLogger(AuditWriter.class);
  private static final int MOST_AT_ONCE = 256;

  private final AuditSettings settings;
  private final AuditIntake intake;
  private final TrailAppender appender;
  private final LongSupplier nanos;
  private volatile boolean isStopping;
  private volatile long written;
  private volatile @Nullable String fault;

  AuditWriter(
      AuditSettings settings, AuditIntake intake, TrailAppender appender, LongSupplier nanos) {
    this.settings = settings;
    this.intake = intake;
    this.appender = appender;
    this.nanos = nanos;
  }

  /** Number of records that were written. */
  long written() {
    return written;
  }

  /** Why records cannot be written now, in a sentence. */
  Optional<String> fault() {
    return Optional.ofNullable(fault);
  }

  /** Asks the thread to write what is there, and to end. */
  void stop() {
    isStopping = true;
  }

  @Override
  public void run() {
    long interval = settings.interval().toNanos();
    long due = nanos.getAsLong() + interval;
    while (!isStopping) {
      try {
        takeUntil(due);
      } catch (InterruptedException e) {
        LOG.warn("audit trail {}: its thread was interrupted and ends", settings.stream());
        isStopping = true;
      }
      if (nanos.getAsLong() - due >= 0) {
        endInterval();
        due = nanos.getAsLong() + interval;
      }
    }
    end();
  }

  private void takeUntil(long due) throws InterruptedException {
    long wait = Math.max(0, due - nanos.getAsLong());
    @Nullable Item first = intake.queue().poll(wait, TimeUnit.NANOSECONDS);
    if (first != null) {
      List<Item> items = new ArrayList<>();
      items.add(first);
      int unused = intake.queue().drainTo(items, MOST_AT_ONCE - 1);
      handle(items);
    }
  }

  private void handle(List<Item> items) {
    List<AuditEntry> entries = new ArrayList<>();
    for (Item item : items) {
      if (item instanceof Queued one) {
        entries.add(one.entry());
      } else if (item instanceof Request request) {
        append(entries);
        entries = new ArrayList<>();
        complete(request);
      }
    }
    append(entries);
  }

  private void complete(Request request) {
    endInterval();
    @Nullable String failure = fault;
    boolean unused =
        failure == null
            ? request.done().complete(appender.durable())
            : request.done().completeExceptionally(new IOException(failure));
  }

  private void endInterval() {
    append(intake.takeSums());
    try {
      appender.force();
    } catch (IOException e) {
      setFault(e);
    }
  }

  private void append(List<AuditEntry> entries) {
    if (entries.isEmpty()) {
      return;
    }
    long before = appender.written();
    try {
      appender.append(entries);
      if (fault != null) {
        fault = null;
        LOG.info("audit trail {}: records can be written again", settings.stream());
      }
    } catch (IOException e) {
      int kept = (int) (appender.written() - before);
      intake.addLost(entries.subList(kept, entries.size()));
      setFault(e);
    }
    written = appender.written();
  }

  private void setFault(IOException e) {
    String sentence =
        "the audit trail "
            + settings.folder().resolve(settings.stream())
            + " cannot be written ("
            + e
            + "); free space on the disk, or repair the folder";
    if (fault == null) { // and not once for each record
      LOG.error("{}; calls are not recorded until then", sentence);
    }
    fault = sentence;
  }

  private void end() {
    List<Item> left = new ArrayList<>();
    int unused = intake.queue().drainTo(left);
    handle(left);
    append(intake.takeSums());
    AuditEvent end = AuditEvent.ofProcess(AuditKind.PROCESS_ENDED, "", "");
    append(List.of(AuditEntry.single(end, intake.now())));
    try {
      appender.force();
      appender.close();
    } catch (IOException e) {
      setFault(e);
    }
  }
}
