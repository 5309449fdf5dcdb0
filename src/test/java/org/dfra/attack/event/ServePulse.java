package org.dfra.attack.event;

import java.io.PrintStream;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.benchmarks.task.Task;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.testing.ServedModule;

/** A robot's lookup service and a module that publishes all the time, in a process of their own. */
public final class ServePulse implements Task {

  private static final Duration LEASE = Duration.ofSeconds(5);

  /** As every task is made. */
  public ServePulse() {}

  /**
   * Argument: the address to serve at. Prints {@code serves PORT}, the port of the lookup service,
   * when the module works. Ends with its input.
   */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    String host = args[0];
    try (EmbeddedRegistrar reggie =
            new EmbeddedRegistrar(host, 0, List.of("attack-" + UUID.randomUUID()), LEASE, Map.of())
                .start();
        ThermometerServer server =
            ServedModule.of(ThermometerServer.class, ThermometerProxy.class, PulseImpl.class)
                .at(host)
                .joining(reggie.locator())
                .serve()) {
      server.awaitReadiness(Duration.ofSeconds(1));
      out.println("serves " + reggie.port());
      int end = System.in.read();
      out.println("ends, since its input gave " + end);
    }
  }
}
