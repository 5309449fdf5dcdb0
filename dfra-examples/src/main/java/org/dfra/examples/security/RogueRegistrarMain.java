package org.dfra.examples.security;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;

/**
 * A lookup service of a stranger, with a receiver that says that it is a robot's. It prints its
 * locator, and when its input ends, who believed it.
 */
public final class RogueRegistrarMain {

  private static final Duration LEASE = Duration.ofMinutes(10);
  private static final int OWN = 2; // the lookup service itself and the receiver
  private static final int MOST = 256;

  private RogueRegistrarMain() {}

  /**
   * Runs until its input ends.
   *
   * @param args name of the robot and of the module that the receiver says that it is
   */
  public static void main(String[] args) throws IOException {
    SerialFilters.install();
    TrustedCode.install();
    EmbeddedRegistrar registrar =
        new EmbeddedRegistrar(DemoEnvironment.ADDRESS, 0, List.of(), LEASE, Map.of()).start();
    try (PretendedGps receiver = new PretendedGps(args[0], args[1])) {
      receiver.register(registrar.registrar());
      System.out.println(registrar.locator());
      while (System.in.read() >= 0) {
        // until its end
      }
      int services =
          registrar.registrar().lookup(new ServiceTemplate(null, null, null), MOST).totalMatches;
      System.out.write(
          (receiver.calls() + " " + (services - OWN) + "\n").getBytes(StandardCharsets.US_ASCII));
      System.out.flush();
    }
    System.exit(0); // the lookup service has threads of its own
  }
}
