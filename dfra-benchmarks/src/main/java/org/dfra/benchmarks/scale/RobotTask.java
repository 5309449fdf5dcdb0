package org.dfra.benchmarks.scale;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.rmi.MarshalledObject;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.benchmarks.task.Task;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.sensor.GPSServer;

/**
 * The process of one robot or several: each has a lookup service, and modules that join it and,
 * where locators are named, others too. Arguments: the robots' names, separated by commas, the
 * number of modules of each, and the locators that they join beside their own. It prints {@code
 * locators} and their locators as soon as each lookup service lists all its robot's modules, and
 * executes the commands of {@link TeamView}, for each of its robots, and {@code toggle}: its first
 * module pauses or resumes, and it prints {@code toggled} and the nanoseconds of the system before
 * that. It ends with its input.
 *
 * <p>Robots in one process share no search, no directory and no renewal, as if each had a process:
 * these are shared by modules of one context class loader only. They share the pool of connections,
 * and the JIT compiler's work.
 */
public final class RobotTask implements Task {

  private static final String HOST = "127.0.0.1";

  /** The longest lease that the robots of DFRA request. */
  private static final Duration LEASE = Duration.ofSeconds(30);

  private static final Duration PATIENCE = Duration.ofMinutes(2);

  /** A strong reference to each. */
  private final List<GPSServer> servers = new ArrayList<>();

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public RobotTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    int modules = Integer.parseInt(args[1]);
    List<String> others = List.of(args).subList(2, args.length);
    List<ClassLoader> loaders = new ArrayList<>();
    List<String> locators = new ArrayList<>();
    Thread here = Thread.currentThread();
    ClassLoader usual = here.getContextClassLoader();
    for (String robot : args[0].split(",", -1)) {
      ClassLoader own = new URLClassLoader(robot, new URL[0], usual);
      loaders.add(own);
      here.setContextClassLoader(own);
      locators.add(start(robot, modules, others));
    }
    here.setContextClassLoader(usual);
    out.println("locators " + String.join(" ", locators));
    execute(loaders, out);
    System.exit(0); // without closing what the kernel closes
  }

  /** Starts a robot; returns its locator when its lookup service lists all its modules. */
  private String start(String robot, int modules, List<String> others) throws Exception {
    EmbeddedRegistrar registrar =
        new EmbeddedRegistrar(HOST, 0, List.of(robot), LEASE, Map.of()).start();
    List<String> joined = new ArrayList<>(List.of(registrar.locator()));
    joined.addAll(others);
    for (int i = 0; i < modules; i++) {
      servers.add(serve(robot, "module" + i, joined));
    }
    awaitListed(registrar.locator(), modules);
    return registrar.locator();
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

  private static void awaitListed(String locator, int modules)
      throws IOException, InterruptedException {
    CountDownLatch listed = new CountDownLatch(modules);
    try (JiniModuleDirectory directory =
            new JiniModuleDirectory(HOST, List.of(), List.of(locator));
        DirectoryRegistration watch =
            directory.listen(ModuleQuery.of(GPSSensor.class), each -> listed.countDown())) {
      if (!listed.await(PATIENCE.toSeconds(), TimeUnit.SECONDS)) {
        throw new IOException(
            listed.getCount() + " modules of a robot are not listed at " + locator + ": " + watch);
      }
    }
  }

  private static void execute(List<ClassLoader> loaders, PrintStream out) throws Exception {
    try (TeamView view = new TeamView(loaders, out);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in))) {
      for (String line; (line = in.readLine()) != null; ) {
        if (line.equals("toggle")) {
          long now = System.nanoTime();
          LightSensor.all().get(0).toggle();
          out.println("toggled " + now);
        } else {
          view.execute(line);
        }
      }
    }
  }
}
