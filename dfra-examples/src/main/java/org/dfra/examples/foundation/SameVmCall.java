package org.dfra.examples.foundation;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.Map;
import java.util.UUID;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.river.proxy.LocalModuleRegistry;
import org.dfra.river.proxy.sensor.GPSProxy;

/** Measures the cost of a smart proxy in the JVM of its own module. */
final class SameVmCall {

  private static final int ROUNDS = 60;
  private static final int CALLS = 100_000;
  private static final int REMOTE_CALLS = 2_000;

  private SameVmCall() {}

  /** Medians over rounds of calls, in nanoseconds per call. */
  record Result(double directNanos, double proxyNanos, double remoteNanos) {}

  /** A call on a receiver. */
  private interface TimedCall {
    double ask() throws RemoteException;
  }

  /**
   * Runs a receiver's driver in this JVM and calls it directly and through a proxy.
   *
   * @param remote the proxy of a module in another process, for comparison
   * @param link to the receiver
   */
  static Result measure(GPSSensor remote, String link) throws RemoteException {
    GPSProxy elsewhere = (GPSProxy) remote;
    UUID id = UUID.randomUUID();
    ModuleContext context =
        new ModuleContext(
            "atrv1",
            "gps_here",
            Parameters.of("atrv1/gps_here", Map.of("link", link)),
            InstantSource.system());
    try (M12PlusImpl here = new M12PlusImpl(context)) {
      here.start();
      here.awaitReadiness(Duration.ofSeconds(10));
      LocalModuleRegistry.register(id, here);
      try {
        GPSSensor proxy = new GPSProxy(elsewhere.server(), id, here.identification());
        double[] direct = new double[ROUNDS];
        double[] through = new double[ROUNDS];
        for (int round = 0; round < ROUNDS; round++) { // in turn: noise affects both equally
          direct[round] = nanos(CALLS, () -> here.fix().speed());
          through[round] = nanos(CALLS, () -> proxy.fix().speed());
        }
        return new Result(
            median(direct), median(through), nanos(REMOTE_CALLS, () -> remote.fix().speed()));
      } finally {
        LocalModuleRegistry.unregister(id, here);
      }
    }
  }

  private static double nanos(int calls, TimedCall asked) throws RemoteException {
    double sum = 0;
    long began = System.nanoTime();
    for (int i = 0; i < calls; i++) {
      sum += asked.ask();
    }
    long took = System.nanoTime() - began;
    if (Double.isNaN(sum)) {
      throw new IllegalStateException("a measured duration is not a number");
    }
    return (double) took / calls;
  }

  private static double median(double[] values) {
    double[] warm = Arrays.copyOfRange(values, values.length / 2, values.length);
    Arrays.sort(warm);
    return warm[warm.length / 2];
  }
}
