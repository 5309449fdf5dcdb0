package org.dfra.core.policy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes to the log of the process what rules oblige to log, and as warnings what they oblige to
 * notify of. At most {@value #MAX_LINES} lines in a second, so that a caller cannot fill the log;
 * it counts the others.
 *
 * <p>Thread: {@code dfra-decisions}, a daemon that ends when it has nothing to write for {@value
 * #IDLE_SECONDS} s. A decision, above all about a stop, does not wait for the disk of the log.
 */
public final class DecisionLog implements DecisionListener {

  /** The most lines in a second. */
  static final int MAX_LINES = 10;

  private static final Logger LOG = LoggerFactory.getLogger(DecisionLog.class);

  /** So many lines wait at most, for a disk that does not take them. */
  private static final int MAX_WAITING = 64;

  private static final int IDLE_SECONDS = 5;

  private static final long SECOND = TimeUnit.SECONDS.toNanos(1);

  private final LongSupplier nanos;
  private final Executor writer;

  @GuardedBy("this")
  private long begin;

  @GuardedBy("this")
  private int lines;

  @GuardedBy("this")
  private long omitted;

  /**
   * @param nanos a monotonic clock in nanoseconds
   */
  public DecisionLog(LongSupplier nanos) {
    this(nanos, thread());
  }

  /**
   * @param writer writes a line elsewhere than on the calling thread
   */
  DecisionLog(LongSupplier nanos, Executor writer) {
    this.nanos = nanos;
    this.writer = writer;
    this.begin = nanos.getAsLong();
  }

  private static Executor thread() {
    ThreadPoolExecutor one =
        new ThreadPoolExecutor(
            1,
            1,
            IDLE_SECONDS,
            TimeUnit.SECONDS,
            new ArrayBlockingQueue<>(MAX_WAITING),
            task -> {
              Thread thread = new Thread(task, "dfra-decisions");
              thread.setDaemon(true);
              return thread;
            });
    one.allowCoreThreadTimeOut(true);
    return one;
  }

  @Override
  public boolean concerns(Obligations obligations) {
    return obligations.isLogged() || obligations.isNotified();
  }

  @Override
  public void onDecision(DecisionRecord decision) {
    if (!concerns(decision.obligations())) {
      return;
    }
    long before = countLine();
    if (before < 0) {
      return;
    }
    try {
      writer.execute(() -> write(decision, before));
    } catch (RejectedExecutionException | OutOfMemoryError e) { // the log stands still
      synchronized (this) {
        omitted += before + 1;
      }
    }
  }

  private static void write(DecisionRecord decision, long before) {
    if (before > 0) {
      LOG.warn("{} decisions of the policy were not logged, since they were too many.", before);
    }
    String sentence = sentence(decision);
    if (decision.obligations().isNotified()) {
      LOG.warn(sentence);
    } else {
      LOG.info(sentence);
    }
  }

  /** Counts a line: the number of lines that were omitted before it, or -1 if it is omitted. */
  synchronized long countLine() {
    long now = nanos.getAsLong();
    if (now - begin >= SECOND) {
      begin = now;
      lines = 0;
    }
    if (lines == MAX_LINES) {
      omitted++;
      return -1;
    }
    lines++;
    long before = omitted;
    omitted = 0;
    return before;
  }

  /** The decision in a sentence. */
  static String sentence(DecisionRecord decision) {
    return (decision.decision().isPermitted() ? "Permitted " : "Refused ")
        + decision.request().methodName()
        + (decision.request().object().isEmpty() ? "" : " on " + decision.request().object())
        + " to "
        + decision.request().caller()
        + " by rule "
        + decision.decision().rule()
        + " of policy version "
        + decision.policyVersion()
        + ".";
  }
}
