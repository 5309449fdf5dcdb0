package org.dfra.benchmarks.scale;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.rmi.MarshalledObject;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.benchmarks.task.Task;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.sensor.GPSServer;

/**
 * A robot's process: a lookup service, and modules that join it and, where locators are named,
 * others too. Arguments: the robot's name, the number of its modules, and the locators that they
 * join beside their own. It prints {@code locator LOCATOR} as soon as its own lookup service lists
 * all its modules, and obeys the commands of {@link TeamView}, and {@code toggle}: its first module
 * pauses or resumes, and it prints {@code toggled} and the nanoseconds of the system before that.
 * It ends with its input.
 */
public final class RobotTask implements Task {

  private static final String HOST = "127.0.0.1";

  /** The longest lease that the robots of DFRA request. */
  private static final Duration LEASE = Duration.ofSeconds(30);

  private static final Duration PATIENCE = Duration.ofMinutes(2);

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public RobotTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    String robot = args[0];
    int modules = Integer.parseInt(args[1]);
    EmbeddedRegistrar registrar =
        new EmbeddedRegistrar(HOST, 0, List.of(robot), LEASE, Map.of()).start();
    List<String> joined = new ArrayList<>(List.of(registrar.locator()));
    joined.addAll(List.of(args).subList(2, args.length));
    List<GPSServer> servers = new ArrayList<>(); // a strong reference to each
    for (int i = 0; i < modules; i++) {
      servers.add(serve(robot, "module" + i, joined));
    }
    awaitListed(registrar.registrar(), modules);
    out.println("locator " + registrar.locator());
    obey(out);
    System.exit(0); // without closing what the kernel closes
  }

  private static GPSServer serve(String robot, String name, List<String> locators)
      throws Exception {
    ModuleDescription description =
        new ModuleDescription(
            robot,
            name,
            GPSServer.class.getName(),
            GPSProxy.class.getName(),
            LightSensor.class.getName(),
            null,
            false,
            Parameters.of(robot + "/" + name, Map.of()),
            SourceLocation.CODE);
    return ModuleServer.started(
        new GPSServer(
            null,
            new MarshalledObject<>(
                new ModuleActivation(description, UUID.randomUUID(), HOST, List.of(), locators))));
  }

  private static void awaitListed(ServiceRegistrar registrar, int modules)
      throws IOException, InterruptedException {
    ServiceTemplate all = new ServiceTemplate(null, null, null);
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (registrar.lookup(all, 0).totalMatches <= modules) { // it lists itself too
      if (System.nanoTime() > end) {
        throw new IOException("a lookup service does not list its robot's modules");
      }
      Thread.sleep(50);
    }
  }

  private static void obey(PrintStream out) throws Exception {
    try (TeamView view = new TeamView(out);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in))) {
      for (String line; (line = in.readLine()) != null; ) {
        if (line.equals("toggle")) {
          long now = System.nanoTime();
          LightSensor.all().get(0).toggle();
          out.println("toggled " + now);
        } else {
          view.obey(line);
        }
      }
    }
  }
}
