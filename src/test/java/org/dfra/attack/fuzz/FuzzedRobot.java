package org.dfra.attack.fuzz;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.ObjectOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.benchmarks.task.Task;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.DirectorySettings;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.registrar.RegistrationPolicy;
import org.dfra.testing.ServedModule;

/**
 * A process that serves a module, runs a registrar if required, looks for lookup services, and
 * reports each of its threads that ends by an exception. Its input has one command a line:
 *
 * <pre>
 *   discover LOCATOR   looks for the lookup service there, repeatedly, until it is stopped
 *   stop               looks for it once more, prints "found ID" and then does nothing
 * </pre>
 */
public final class FuzzedRobot implements Task {

  /** How a line begins that reports the end of a thread. */
  static final String DIED = "died";

  /** An argument. */
  static final String WITH_REGISTRAR = "registrar";

  /** Short, so that what changed calls register is soon forgotten. */
  private static final Duration REGISTRAR_LEASE = Duration.ofSeconds(2);

  private static final Duration RETRY = Duration.ofMillis(1);
  private static final long POLL_NANOS = TimeUnit.MILLISECONDS.toNanos(1);

  private volatile boolean stopping;

  /** As every task is made. */
  public FuzzedRobot() {}

  /**
   * Arguments: the address to serve at, a file that the module's remote proxy is put into, and
   * {@link #WITH_REGISTRAR} for one that also runs a registrar. It prints "serves" and the
   * registrar's port, or 0.
   */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    Thread.setDefaultUncaughtExceptionHandler(
        (thread, reason) -> {
          out.println(DIED + " " + thread.getName() + ": " + reason);
          reason.printStackTrace();
        });
    ServedModule<ThermometerServer> module =
        ServedModule.of(
                ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
            .at(args[0]);
    RegistrationPolicy policy = new RegistrationPolicy("eta", List.of());
    try (ThermometerServer server = module.serve();
        EmbeddedRegistrar registrar =
            new EmbeddedRegistrar(args[0], 0, List.of(), REGISTRAR_LEASE, policy, Map.of())) {
      write(server.getProxy(), Path.of(args[1]));
      boolean hasRegistrar = List.of(args).contains(WITH_REGISTRAR);
      out.println("serves " + (hasRegistrar ? registrar.start().port() : 0));
      BufferedReader in =
          new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
      for (String line; (line = in.readLine()) != null; ) {
        if (line.equals("stop")) {
          stopping = true;
        } else {
          String locator = line.split(" ")[1];
          new Thread(() -> discover(args[0], locator, out), "discover again and again").start();
        }
      }
    }
  }

  private static void write(Object proxy, Path file) throws Exception {
    Path part = file.resolveSibling(file.getFileName() + ".part");
    try (ObjectOutputStream stream = new ObjectOutputStream(Files.newOutputStream(part))) {
      stream.writeObject(proxy);
    }
    Files.move(part, file, StandardCopyOption.ATOMIC_MOVE);
  }

  private void discover(String host, String locator, PrintStream out) {
    try {
      while (!stopping) {
        ServiceRegistrar unused = find(host, locator);
      }
      out.println("found " + find(host, locator).getServiceID());
    } catch (Exception e) {
      throw new IllegalStateException("discovery at " + locator + " ended", e);
    }
  }

  /** As a robot finds one that was restarted: with a directory of its own. */
  private static ServiceRegistrar find(String host, String locator) throws Exception {
    DirectorySettings usual = DirectorySettings.of(host, List.of(), List.of(locator));
    DirectorySettings settings =
        new DirectorySettings(
            usual.callbackHost(),
            usual.groups(),
            usual.locators(),
            RETRY,
            usual.heartbeatInterval(),
            usual.registrarTimeout(),
            usual.reconcileInterval(),
            usual.eventLease());
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory(settings, InstantSource.system())) {
      while (true) {
        List<ServiceRegistrar> found = directory.lookupServices();
        if (!found.isEmpty()) {
          return found.get(0);
        }
        LockSupport.parkNanos(POLL_NANOS);
      }
    }
  }
}
