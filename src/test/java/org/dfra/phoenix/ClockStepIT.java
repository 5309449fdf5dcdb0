package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;
import static org.awaitility.Awaitility.await;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.lookup.entry.Name;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.InteractiveProcess;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The clock of a registrar's computer, or of a module's, is set by an hour: within one lease and 5
 * s what lives is listed again, and what is dead is not. The clocks are set by libfaketime
 * (Debian's package {@code faketime}); monotonic time is left alone, as it is where a real clock is
 * set.
 */
@Timeout(240)
class ClockStepIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final Duration LEASE = Duration.ofMillis(EmbeddedReggie.LEASE_MILLIS);
  private static final Duration BOUND = LEASE.plusSeconds(5);

  /** Between looks at what is listed; fewer in the everyday tier. */
  private static final Duration POLL =
      Duration.ofMillis(Boolean.getBoolean("dfra.full") ? 100 : 300);

  /** Seconds that a clock is ahead, one after the other: it is set back by an hour, and forward. */
  private static final List<Long> STEPS = List.of(-3600L, 0L);

  @TempDir Path folder;

  private final StallProbe probe = StallProbe.start();

  @AfterEach
  void end() {
    probe.close();
  }

  /** A process whose clock can be set. */
  private final class Skewed implements AutoCloseable {

    private final Path clock;
    private final InteractiveProcess process;
    final String output;

    Skewed(Class<?> main, String... arguments) throws Exception {
      Optional<Path> library = library();
      assumeThat(library).as("libfaketime; install Debian's package faketime").isPresent();
      clock = folder.resolve(main.getSimpleName() + ".clock");
      set(0);
      List<String> command =
          new ArrayList<>(
              List.of(
                  "env",
                  "LD_PRELOAD=" + library.orElseThrow(),
                  "FAKETIME_TIMESTAMP_FILE=" + clock,
                  "FAKETIME_CACHE_DURATION=1",
                  "FAKETIME_DONT_FAKE_MONOTONIC=1",
                  "DONT_FAKE_MONOTONIC=1",
                  "FAKETIME_FORCE_MONOTONIC_FIX=0")); // it ends every timed wait at once
      command.addAll(InteractiveProcess.java(System.getProperty("java.class.path"), List.of()));
      command.add(main.getName());
      command.addAll(List.of(arguments));
      process = new InteractiveProcess(command);
      output = process.awaitLine();
    }

    private static Optional<Path> library() throws IOException {
      try (Stream<Path> files = Files.walk(Path.of("/usr/lib"), 3)) {
        return files.filter(file -> file.endsWith("faketime/libfaketimeMT.so.1")).findFirst();
      }
    }

    /** Sets it that far before or after the computer's, and proves that it waits as before. */
    void step(long seconds) throws Exception {
      set(seconds);
      await("clock set by " + seconds + " s") // it looks at the file once a second
          .atMost(PATIENCE)
          .until(() -> ahead().minusSeconds(seconds).abs().compareTo(LEASE) < 0);
      assertThat(Long.parseLong(process.request("wait"))).as("ms waited").isGreaterThan(99);
    }

    private Duration ahead() throws Exception {
      return Duration.between(Instant.now(), Instant.parse(process.request("time")));
    }

    private void set(long seconds) throws IOException {
      Path next = clock.resolveSibling(clock.getFileName() + ".next");
      Path beside = Files.writeString(next, "%+d".formatted(seconds) + "\n");
      Path unused = Files.move(beside, clock, StandardCopyOption.ATOMIC_MOVE);
    }

    @Override
    public void close() throws Exception {
      process.close();
    }
  }

  /** Answers each line: with its time, or with how many milliseconds a wait of 100 ms took. */
  private static void answer() throws Exception {
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    CountDownLatch never = new CountDownLatch(1);
    for (String line = in.readLine(); line != null; line = in.readLine()) {
      long begun = System.nanoTime();
      boolean isWait = line.equals("wait") && !never.await(100, TimeUnit.MILLISECONDS);
      Object answer =
          isWait ? Duration.ofNanos(System.nanoTime() - begun).toMillis() : Instant.now();
      System.out.println(InteractiveProcess.RESPONSE_PREFIX + answer);
    }
  }

  /** A lookup service as a process. */
  static final class Registrar {
    public static void main(String[] args) throws Exception {
      try (EmbeddedRegistrar reggie =
          new EmbeddedRegistrar(
                  EmbeddedReggie.HOST, 0, List.of("g" + UUID.randomUUID()), LEASE, Map.of())
              .start()) {
        System.out.println(InteractiveProcess.RESPONSE_PREFIX + reggie.locator());
        answer();
      }
    }
  }

  /** A module as a process; its argument is a locator. */
  static final class Served {
    public static void main(String[] args) throws Exception {
      try (ThermometerServer server = thermometer(args[0]).serve()) {
        System.out.println(InteractiveProcess.RESPONSE_PREFIX + server);
        answer();
      }
    }
  }

  private static ServiceItem dead() {
    return new ServiceItem(null, "a proxy", new Entry[] {new Name("dead")});
  }

  private static ServedModule<ThermometerServer> thermometer(String locator) {
    return ServedModule.of(
            ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
        .joining(locator);
  }

  /** The names that are listed. */
  private static Set<String> listed(ServiceRegistrar registrar) throws RemoteException {
    ServiceTemplate named = new ServiceTemplate(null, null, new Entry[] {new Name()});
    return Arrays.stream(registrar.lookup(named, Integer.MAX_VALUE).items)
        .flatMap(item -> Arrays.stream(item.attributeSets))
        .filter(Name.class::isInstance)
        .map(entry -> ((Name) entry).name)
        .filter(name -> !name.equals("Lookup"))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Within the bound, and from then on. */
  private void awaitListed(ServiceRegistrar registrar, StallProbe.Stopwatch watch, String... names)
      throws Exception {
    Listings listings = new Listings(registrar, watch);
    await("listing of " + List.of(names))
        .atMost(PATIENCE)
        .pollInterval(POLL)
        .until(() -> hasPassed(watch) && listings.next().equals(Set.of(names)));
    Timing listed = watch.stop();
    System.out.printf("listed aright after a step of the clock: %s%n", listed);
    await("that it stays so")
        .during(LEASE.plusSeconds(1))
        .atMost(PATIENCE)
        .pollInterval(POLL)
        .until(() -> listings.next().equals(Set.of(names)));
    listed.requireWithin("being listed aright after a step of the clock (" + listings + ")", BOUND);
  }

  /** What a registrar lists from time to time, for the message of a failure. */
  private static final class Listings {

    private final ServiceRegistrar registrar;
    private final StallProbe.Stopwatch watch;
    private final List<String> changes = new ArrayList<>();
    private String last = "";

    Listings(ServiceRegistrar registrar, StallProbe.Stopwatch watch) {
      this.registrar = registrar;
      this.watch = watch;
    }

    /** The names listed now; empty if the call fails, for one may miss its deadline. */
    Set<String> next() {
      Set<String> names = Set.of();
      Duration asked = watch.stop().took();
      String seen;
      try {
        names = listed(registrar);
        seen = names.toString();
      } catch (RemoteException e) {
        seen = e.toString();
      }
      if (!seen.equals(last)) {
        changes.add(
            "asked after %s, answered after %s: %s".formatted(asked, watch.stop().took(), seen));
        last = seen;
      }
      return names;
    }

    @Override
    public String toString() {
      return String.join("; ", changes);
    }
  }

  /** By then every holder that is to be dropped has been. */
  private static boolean hasPassed(StallProbe.Stopwatch watch) {
    return watch.stop().took().compareTo(LEASE) > 0;
  }

  /** Both at once: what takes its time is the end of leases. */
  @Test
  void whatLivesIsListedWhicheverClockIsSet() throws Exception {
    ExecutorService threads = Executors.newSingleThreadExecutor();
    try {
      Future<?> registrars =
          threads.submit(
              () -> {
                setTheClockOfARegistrar();
                return null;
              });
      setTheClockOfAModulesComputer();
      registrars.get();
    } finally {
      threads.shutdownNow();
      assertThat(threads.awaitTermination(PATIENCE.toSeconds(), TimeUnit.SECONDS)).isTrue();
    }
  }

  private void setTheClockOfARegistrar() throws Exception {
    try (Skewed process = new Skewed(Registrar.class)) {
      LookupLocator locator = new LookupLocator(process.output);
      ServiceRegistrar registrar = locator.getRegistrar();
      try (ThermometerServer server = thermometer(process.output).serve()) {
        await(server.toString())
            .atMost(PATIENCE)
            .ignoreExceptionsInstanceOf(RemoteException.class)
            .until(() -> listed(registrar).contains("robot/module"));
        for (long step : STEPS) {
          await("registration of one that never renews")
              .atMost(PATIENCE)
              .ignoreExceptionsInstanceOf(RemoteException.class)
              .until(() -> registrar.register(dead(), LEASE.toMillis()) != null);
          process.step(step);
          StallProbe.Stopwatch begun = probe.stopwatch();
          awaitListed(registrar, begun, "robot/module");
        }
      }
    }
  }

  private void setTheClockOfAModulesComputer() throws Exception {
    try (EmbeddedReggie reggie = new EmbeddedReggie().start();
        Skewed process = new Skewed(Served.class, reggie.locator())) {
      await(process.output)
          .atMost(PATIENCE)
          .until(() -> listed(reggie.registrar()).contains("robot/module"));
      for (long step : STEPS) {
        process.step(step);
        StallProbe.Stopwatch begun = probe.stopwatch();
        awaitListed(reggie.registrar(), begun, "robot/module");
      }
    }
  }
}
