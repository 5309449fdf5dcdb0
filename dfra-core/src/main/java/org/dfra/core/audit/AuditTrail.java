package org.dfra.core.audit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.security.PrivateKey;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.core.audit.AuditIntake.Request;
import org.dfra.core.host.PrivateFiles;
import org.dfra.security.AccessRequest;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Records what concerns security in files that a process appends to, as a chain of lines.
 *
 * <p>{@link #record} and {@link #recordRead} never wait: they may be called for each call that a
 * robot receives. A daemon thread {@code dfra-audit-STREAM} writes; {@link #start} starts it, and
 * {@link #close} ends it. Events before the start wait in the queue. Thread-safe.
 *
 * <p>An event is written at once, and again as a sum at the end of each interval in which equal
 * ones follow. Permitted reads are only summed. Events that find the queue full, exceed the rates
 * of the {@link AuditSettings} or cannot be written are counted, and the trail has their number.
 */
public final class AuditTrail implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(AuditTrail.class);
  private static final Duration CLOSE_TIMEOUT = Duration.ofSeconds(5);

  private final AuditSettings settings;
  private final InstantSource clock;
  private final AppendFile.Opener opener;
  private final AuditIntake intake;

  @GuardedBy("this")
  private @Nullable StreamLock lock;

  @GuardedBy("this")
  private @Nullable Thread thread;

  private volatile @Nullable AuditWriter writer;

  /**
   * @param clock of the records, in UTC
   */
  public AuditTrail(AuditSettings settings, InstantSource clock) {
    this(settings, clock, AppendFile::open);
  }

  /** For tests: with files that can fail. */
  AuditTrail(AuditSettings settings, InstantSource clock, AppendFile.Opener opener) {
    this.settings = settings;
    this.clock = clock;
    this.opener = opener;
    intake = new AuditIntake(settings, clock);
  }

  /**
   * Finds the end of the stream, which it continues, and starts the thread. Does nothing if it is
   * started.
   *
   * @throws IOException if the folder is not private, another process writes the stream, or the
   *     stream cannot be read; the message says what to do
   */
  public synchronized void start() throws IOException {
    if (thread != null) {
      return;
    }
    PrivateFiles.requireFolder(settings.folder());
    StreamLock held = StreamLock.lock(settings.folder(), settings.stream());
    try {
      TrailRecovery recovered = TrailRecovery.recover(settings.folder(), settings.stream());
      TrailAppender appender = new TrailAppender(settings, clock, opener, recovered);
      for (String each : recovered.torn()) {
        record(AuditEvent.ofProcess(AuditKind.TORN_LINE, "", each));
      }
      AuditWriter made = new AuditWriter(settings, intake, appender, System::nanoTime);
      Thread started = new Thread(made, "dfra-audit-" + settings.stream());
      started.setDaemon(true);
      started.start();
      writer = made;
      thread = started;
      lock = held;
    } catch (IOException | RuntimeException | Error e) {
      held.close();
      throw e;
    }
  }

  /** Records an event. Never waits and never throws. */
  public void record(AuditEvent event) {
    intake.add(event);
  }

  /** Counts a permitted call that only reads. Never waits and never throws. */
  public void recordRead(AccessRequest request) {
    intake.addRead(request);
  }

  /** How it works at present. */
  public AuditStatus status() {
    @Nullable AuditWriter running = writer;
    return running == null
        ? new AuditStatus(
            0, intake.dropped(), Optional.of("the audit trail is not started or is closed"))
        : new AuditStatus(running.written(), intake.dropped(), running.fault());
  }

  /**
   * Ends the interval: writes all sums, and syncs the trail to the disk.
   *
   * @param patience longest time that this waits
   * @throws IOException if it takes longer, or the disk fails; the records stay where they are
   * @throws InterruptedException if this thread is interrupted
   */
  public void flush(Duration patience) throws IOException, InterruptedException {
    TrailPosition unused = await(patience);
  }

  /**
   * The signed end of the stream, for other members. All records before this call are on the disk
   * when this returns, so a loss of power cannot make an honest robot's trail end before its head.
   *
   * @param key private key of the process's certificate, for ECDSA
   * @param patience longest time that this waits
   * @throws IOException if it takes longer, or the disk fails, or the stream is empty
   * @throws InterruptedException if this thread is interrupted
   * @throws IllegalArgumentException if the key is not for ECDSA
   */
  public AuditHead head(PrivateKey key, Duration patience)
      throws IOException, InterruptedException {
    TrailPosition end = await(patience);
    if (end.number() == 0) {
      throw new IOException("the audit trail " + settings.stream() + " has no record yet");
    }
    return AuditHead.sign(settings.stream(), end.number(), end.hash(), clock.instant(), key);
  }

  private TrailPosition await(Duration patience) throws IOException, InterruptedException {
    Request request = new Request(new CompletableFuture<>());
    long begin = System.nanoTime();
    try {
      if (writer == null
          || !intake.queue().offer(request, patience.toNanos(), TimeUnit.NANOSECONDS)) {
        throw new TimeoutException();
      }
      long left = patience.toNanos() - (System.nanoTime() - begin);
      return request.done().get(Math.max(0, left), TimeUnit.NANOSECONDS);
    } catch (ExecutionException e) {
      @Nullable Throwable cause = e.getCause();
      throw new IOException(String.valueOf(cause == null ? e : cause.getMessage()), e);
    } catch (TimeoutException e) {
      throw new IOException(
          "the audit trail "
              + settings.stream()
              + " is closed, or was not on the disk within "
              + patience.toMillis()
              + " ms",
          e);
    }
  }

  /**
   * Writes what is there with a last record, and ends the thread. Waits for it for at most 5 s;
   * then the thread writes what is left if the disk works again, and the stream stays locked until
   * then.
   */
  @Override
  public synchronized void close() {
    @Nullable AuditWriter running = writer;
    @Nullable Thread ending = thread;
    if (running == null || ending == null) {
      return;
    }
    running.stop();
    boolean unused = intake.queue().offer(new Request(new CompletableFuture<>())); // wakes it
    try {
      ending.join(CLOSE_TIMEOUT.toMillis());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (ending.isAlive()) {
      LOG.error("the audit trail {} is not written yet: the disk is slow", settings.stream());
      return;
    }
    running.fault().ifPresent(fault -> LOG.error("{}; the last records are lost", fault));
    writer = null;
    thread = null;
    unlock();
  }

  @GuardedBy("this")
  private void unlock() {
    @Nullable StreamLock held = lock;
    lock = null;
    if (held != null) {
      try {
        held.close();
      } catch (IOException e) {
        LOG.warn("the lock of the audit trail {} cannot be closed", settings.stream(), e);
      }
    }
  }
}
