package org.dfra.benchmarks.scale;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.transport.TransportTraffic;

/**
 * What the robots or the observer of one process know of a team, and what it costs. Commands, and
 * what they print:
 *
 * <ul>
 *   <li>{@code watch MODULES LOCATOR…}: each knows the team from now on, by a directory of its own;
 *       {@code complete} and the nanoseconds until the last one knew so many modules;
 *   <li>{@code traffic}: {@code traffic}, the calls sent and served, the bytes sent and received
 *       since its start, and the number of its Java threads;
 *   <li>{@code stop}: knows nothing any more; {@code stopped}.
 * </ul>
 *
 * <p>While it knows the team, it prints {@code saw} and the nanoseconds of the system when a module
 * has paused or resumed.
 */
final class TeamView implements AutoCloseable {

  private static final String HOST = "127.0.0.1";
  private static final int PATIENCE_MINUTES = 15;

  private final List<ClassLoader> loaders;
  private final PrintStream out;
  private final List<JiniModuleDirectory> directories = new ArrayList<>();
  private final List<DirectoryRegistration> registrations = new ArrayList<>();

  /**
   * @param loaders one context class loader for each robot or observer
   */
  TeamView(List<ClassLoader> loaders, PrintStream out) {
    this.loaders = List.copyOf(loaders);
    this.out = out;
  }

  /**
   * Executes a command.
   *
   * @throws IOException if the team is not complete in time, or the command is unknown
   */
  void execute(String line) throws IOException, InterruptedException {
    List<String> words = Arrays.asList(line.split(" ", -1));
    switch (words.get(0)) {
      case "watch" -> watch(Integer.parseInt(words.get(1)), words.subList(2, words.size()));
      case "traffic" -> {
        TransportTraffic now = TransportTraffic.now();
        out.println(
            "traffic "
                + now.callsSent()
                + " "
                + now.callsServed()
                + " "
                + now.bytesSent()
                + " "
                + now.bytesReceived()
                + " "
                + ManagementFactory.getThreadMXBean().getThreadCount());
      }
      case "stop" -> {
        close();
        out.println("stopped");
      }
      default -> throw new IOException("unknown command: " + line);
    }
  }

  private void watch(int modules, List<String> locators) throws IOException, InterruptedException {
    long began = System.nanoTime();
    Thread here = Thread.currentThread();
    ClassLoader usual = here.getContextClassLoader();
    List<Changes> all = new ArrayList<>();
    for (ClassLoader each : loaders) {
      here.setContextClassLoader(each);
      JiniModuleDirectory opened = new JiniModuleDirectory(HOST, List.of(), locators);
      directories.add(opened);
      Changes changes = new Changes(modules);
      all.add(changes);
      registrations.add(opened.listen(ModuleQuery.of(GPSSensor.class), changes));
    }
    here.setContextClassLoader(usual);
    long last = began;
    for (Changes each : all) {
      if (!each.complete.await(PATIENCE_MINUTES, TimeUnit.MINUTES)) {
        throw new IOException(each.complete.getCount() + " modules were not found");
      }
      last = Math.max(last, each.completeAt());
    }
    out.println("complete " + (last - began));
  }

  /** Counts the modules, and reports changes of their state. */
  private final class Changes implements DirectoryListener<GPSSensor> {

    private final CountDownLatch complete;

    @GuardedBy("this")
    private long completeAt;

    Changes(int modules) {
      complete = new CountDownLatch(modules);
    }

    synchronized long completeAt() {
      return completeAt;
    }

    @Override
    public void matched(ModuleListing<GPSSensor> listing) {
      synchronized (this) {
        completeAt = System.nanoTime();
      }
      complete.countDown();
    }

    @Override
    public void changed(ModuleListing<GPSSensor> before, ModuleListing<GPSSensor> now) {
      long at = System.nanoTime();
      if (isPaused(before) != isPaused(now)) {
        out.println("saw " + at);
      }
    }
  }

  private static boolean isPaused(ModuleListing<GPSSensor> listing) {
    return listing
        .attributes(ModuleAttributes.class)
        .filter(each -> each.state() == Readiness.PAUSED)
        .isPresent();
  }

  @Override
  public void close() {
    registrations.forEach(DirectoryRegistration::close);
    registrations.clear();
    directories.forEach(JiniModuleDirectory::close);
    directories.clear();
  }
}
