package org.dfra.app.bench;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.Kind;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.JiniModuleDirectory;

/**
 * A process that listens to a receiver and notes when it was told. To {@code clock} on its input it
 * answers what time it is, to {@code report} what it noted, {@code number nanoseconds} in a line,
 * and an empty line.
 */
final class ListenerMain {

  private static final Duration PATIENCE = Duration.ofMinutes(1);
  private static final int DEPTH = 50;

  private ListenerMain() {}

  /** When the event of this number came. */
  private record Told(long number, long nanos) {}

  public static void main(String[] args) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    PrintStream out = new PrintStream(System.out, true);
    Queue<Told> told = new ConcurrentLinkedQueue<>();
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory(BenchRegistrar.HOST, List.of(), List.of(args[0]))) {
      GPSSensor gps =
          directory.findFirst(ModuleQuery.of(GPSSensor.class), PATIENCE).orElseThrow().module();
      try (Subscription subscription =
          gps.subscribe(
              event -> {
                long now = System.nanoTime();
                if (event.kind() == Kind.READING) {
                  told.add(new Told(event.sequence(), now));
                }
              },
              DeliveryPolicy.keepLast(DEPTH))) {
        out.println("ready");
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
        for (String line; (line = in.readLine()) != null; ) {
          if (line.equals("clock")) {
            out.println(System.nanoTime());
          } else {
            told.forEach(each -> out.println(each.number() + " " + each.nanos()));
            out.println(subscription.interruptedSince().isEmpty() ? "" : "interrupted");
          }
        }
      }
    }
    System.exit(0);
  }
}
