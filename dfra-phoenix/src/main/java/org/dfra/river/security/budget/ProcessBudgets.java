package org.dfra.river.security.budget;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Path;
import java.rmi.server.ExportException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;
import java.util.concurrent.locks.LockSupport;
import org.dfra.core.budget.BudgetGuard;
import org.dfra.core.budget.ListenerPriority;
import org.dfra.core.budget.RadioThinning;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.call.ProcessObject;
import org.dfra.river.transport.TransportTraffic;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The budgets of this process.
 *
 * <p>Thread: {@code dfra-radio}, a daemon that measures the network as long as the policy declares
 * its rate.
 */
public final class ProcessBudgets implements BudgetMonitor {

  private static final Logger LOG = LoggerFactory.getLogger(ProcessBudgets.class);

  private static final ProcessObject<BudgetMonitor> MONITOR =
      new ProcessObject<>(
          "0f0c3f7e-52c4-4f1b-8a1e-6f1d7a3b9c55",
          BudgetMonitor.class,
          DeadlineILFactory.DEFAULT_DEADLINE);

  private static final String FILE = "radio";

  private final BudgetGuard guard;
  private final Path file;
  private final LongAdder thinned = new LongAdder();
  private volatile int[] oneIn = RadioThinning.none();
  private volatile @Nullable RadioFile radio;

  @GuardedBy("this")
  private boolean isMeasuring;

  private final ProcessObject<BudgetMonitor>.Own monitor = MONITOR.own(this);

  /**
   * @param state the state folder, which all processes of the computer's robots share
   */
  public ProcessBudgets(BudgetGuard guard, Path state) {
    this.guard = guard;
    this.file = state.resolve(FILE);
  }

  /** Which calls and listeners are admitted. */
  public BudgetGuard guard() {
    return guard;
  }

  /** Of the readings for listeners of a priority, every n-th is sent to other computers. */
  public int oneIn(ListenerPriority priority) {
    return oneIn[priority.ordinal()];
  }

  /** Counts readings that are not sent, since the radio's rate is reached. */
  public void countThinned(long readings) {
    thinned.add(readings);
  }

  /** Begins to measure the network, if the policy in force declares its rate. */
  public synchronized void policyChanged() {
    if (!isMeasuring && guard.radio().isPresent()) {
      isMeasuring = true;
      Thread thread = new Thread(this::measure, "dfra-radio");
      thread.setDaemon(true);
      thread.start();
    }
  }

  private void measure() {
    try {
      RadioFile open = RadioFile.open(file);
      radio = open;
      long before = TransportTraffic.bytesOfNetwork();
      while (true) {
        Optional<Double> max = guard.radio();
        if (max.isEmpty()) {
          if (isEnded()) {
            return;
          }
          continue;
        }
        long now = TransportTraffic.bytesOfNetwork();
        open.add(now - before, max.get(), System.nanoTime());
        before = now;
        oneIn = open.oneIn();
        LockSupport.parkNanos(this, RadioFile.STEP_NANOS);
      }
    } catch (IOException e) {
      LOG.error("The rate of the radio is not kept: {}", e.getMessage());
    }
  }

  /** Whether nothing is to be measured; a policy that is replaced meanwhile is not overlooked. */
  private synchronized boolean isEnded() {
    if (guard.radio().isPresent()) {
      return false;
    }
    isMeasuring = false;
    radio = null;
    oneIn = RadioThinning.none();
    return true;
  }

  /**
   * Exports {@link BudgetMonitor} at the port of everything else that this process exports at a
   * host. Does nothing the second time.
   *
   * @param host address of this computer, as in its proxies
   */
  public void export(String host) throws ExportException {
    monitor.export(host);
  }

  /**
   * The same at another port of this process.
   *
   * @param port TCP port; 0 for that of everything that is exported at no other
   */
  public void export(String host, int port) throws ExportException {
    monitor.export(host, port);
  }

  /** The budgets of another process. */
  public static BudgetMonitor at(PeerAddress process) {
    return MONITOR.of(process);
  }

  @Override
  public Report budgets() {
    RadioFile now = radio;
    double max = guard.radio().orElse(0.0);
    List<Integer> levels = Arrays.stream(oneIn).boxed().toList();
    return new Report(
        guard.use(), new RadioUse(now == null ? 0 : now.rate(), max, levels, thinned.sum()));
  }
}
