package org.dfra.benchmarks;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import net.jini.config.EmptyConfiguration;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.directory.Condition;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.persona.SensorAttributes;
import org.dfra.river.entry.Entries;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.lookup.LookupJoin;

/** Measures the cost of the distributed layer, with real lookup services on the loopback. */
final class DistributedBench implements Bench {

  private static final int FEW = 100;
  private static final int MANY = 10_000;
  private static final int ROUNDS = 5;
  private static final int LOOKUPS = 400;
  private static final int QUERIES = 200;
  private static final long LONG_LEASE = Duration.ofMinutes(30).toMillis();
  private static final long SHORT_LEASE = 5_000;
  private static final int JOINED = 20;
  private static final long ROBOT_LEASE = 30_000;

  @Override
  public void run(Report report) throws Exception {
    lookups(report);
    staleness(report);
    renewals(report);
    new EventBench().run(report);
  }

  private static void register(ServiceRegistrar registrar, int modules) throws IOException {
    for (int i = 0; i < modules; i++) {
      BenchModule module = BenchModule.of(i);
      registrar.register(item(module, i), LONG_LEASE);
    }
  }

  private static ServiceItem item(BenchModule module, int number) {
    UUID id = module.id();
    return new ServiceItem(
        new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits()),
        module,
        Entries.toEntries(module.attributes(number)));
  }

  private void lookups(Report report) throws Exception {
    report.say("Registering " + FEW + " and " + MANY + " modules …");
    try (BenchRegistrar small = new BenchRegistrar(LONG_LEASE);
        BenchRegistrar large = new BenchRegistrar(LONG_LEASE)) {
      register(small.registrar(), FEW);
      register(large.registrar(), MANY);
      double[] few = new double[ROUNDS * LOOKUPS];
      double[] many = new double[ROUNDS * LOOKUPS];
      time(small.registrar(), FEW, few, 0); // to warm up
      time(large.registrar(), MANY, many, 0);
      for (int round = 0; round < ROUNDS; round++) { // in turn: noise affects both equally
        time(small.registrar(), FEW, few, round * LOOKUPS);
        time(large.registrar(), MANY, many, round * LOOKUPS);
      }
      double fewMedian = Report.quantile(few, 0.5) / 1e3;
      double manyMedian = Report.quantile(many, 0.5) / 1e3;
      report.figure("lookup by template, median, " + FEW + " modules", fewMedian, "µs");
      report.figure("lookup by template, median, " + MANY + " modules", manyMedian, "µs");
      report.figure(
          "lookup by template, the second over the first", manyMedian / fewMedian, 1.2, "");
      queries(report, large);
    }
  }

  /** Times the look-up of one module by robot and name. */
  private static void time(ServiceRegistrar registrar, int modules, double[] nanos, int from)
      throws IOException {
    for (int i = 0; i < LOOKUPS; i++) {
      BenchModule wanted = BenchModule.of((i * 7919) % modules);
      ModuleEntry entry = new ModuleEntry();
      entry.robot = wanted.robot();
      entry.name = wanted.name();
      ServiceTemplate template = new ServiceTemplate(null, null, new Entry[] {entry});
      long began = System.nanoTime();
      Object found = registrar.lookup(template);
      nanos[from + i] = System.nanoTime() - began;
      if (!(found instanceof BenchModule module) || !module.name().equals(wanted.name())) {
        throw new IOException("looked up " + wanted + ", found " + found);
      }
    }
  }

  private void queries(Report report, BenchRegistrar large) throws Exception {
    CountDownLatch known = new CountDownLatch(MANY);
    try (JiniModuleDirectory directory =
            new JiniModuleDirectory(BenchRegistrar.HOST, List.of(), List.of(large.locator()));
        DirectoryRegistration watch =
            directory.listen(ModuleQuery.of(Module.class), each -> known.countDown())) {
      long began = System.nanoTime();
      if (!known.await(2, TimeUnit.MINUTES)) {
        throw new IOException(known.getCount() + " modules did not reach " + watch);
      }
      report.figure(
          "a new client's cache complete, " + MANY + " modules",
          (System.nanoTime() - began) / 1e9,
          "s");
      ThreadMXBean threads = ManagementFactory.getThreadMXBean();
      double[] nanos = new double[ROUNDS * QUERIES];
      double[] busy = new double[ROUNDS * QUERIES];
      for (int pass = 0; pass < 2; pass++) { // the first warms up
        for (int i = 0; i < nanos.length; i++) {
          ModuleQuery<Module> query =
              ModuleQuery.of(Module.class)
                  .where(SensorAttributes.class, "maxRate", Condition.atLeast(36 + i % 4))
                  .where(SensorAttributes.class, "modes", Condition.contains("night"));
          long worked = threads.getCurrentThreadCpuTime();
          long asked = System.nanoTime();
          List<ModuleListing<Module>> found = directory.find(query);
          nanos[i] = System.nanoTime() - asked;
          busy[i] = threads.getCurrentThreadCpuTime() - worked;
          if (found.isEmpty()) {
            throw new IOException("nothing matches " + query);
          }
        }
      }
      report.figure(
          "predicate query on the cache, median", Report.quantile(nanos, 0.5) / 1e6, "ms");
      report.figure(
          "predicate query on the cache, p99", Report.quantile(nanos, 0.99) / 1e6, 5, "ms");
    }
  }

  private void staleness(Report report) throws Exception {
    report.say("Letting modules die …");
    int dying = 5;
    CountDownLatch seen = new CountDownLatch(dying);
    CountDownLatch gone = new CountDownLatch(dying);
    double[] times = new double[dying];
    List<UUID> ids = new ArrayList<>();
    try (BenchRegistrar reggie = new BenchRegistrar(SHORT_LEASE);
        JiniModuleDirectory directory =
            new JiniModuleDirectory(BenchRegistrar.HOST, List.of(), List.of(reggie.locator()))) {
      long[] registered = new long[dying];
      DirectoryListener<Module> listener =
          new DirectoryListener<>() {
            @Override
            public void matched(ModuleListing<Module> listing) {
              seen.countDown();
            }

            @Override
            public void unmatched(ModuleListing<Module> last) {
              int i = ids.indexOf(last.id());
              times[i] = System.nanoTime() - registered[i];
              gone.countDown();
            }
          };
      for (int i = 0; i < dying; i++) {
        BenchModule module = BenchModule.of(i);
        ids.add(module.id());
        registered[i] = System.nanoTime();
        reggie.registrar().register(item(module, i), SHORT_LEASE); // and not renewed
      }
      try (DirectoryRegistration watch = directory.listen(ModuleQuery.of(Module.class), listener)) {
        if (!seen.await(SHORT_LEASE, TimeUnit.MILLISECONDS)
            || !gone.await(4 * SHORT_LEASE, TimeUnit.MILLISECONDS)) {
          throw new IOException(gone.getCount() + " dead modules are still listed by " + watch);
        }
      }
    }
    report.figure(
        "staleness of a dead module over its lease of 5 s, median of " + dying,
        Report.quantile(times, 0.5) / 1e6 / SHORT_LEASE,
        1.1,
        "");
    report.figure(
        "staleness of a dead module over its lease of 5 s, worst of " + dying,
        Report.quantile(times, 1) / 1e6 / SHORT_LEASE,
        1.1,
        "");
  }

  private void renewals(Report report) throws Exception {
    report.say("Counting what " + JOINED + " idle modules send for two leases of 30 s …");
    List<LookupJoin> joins = new ArrayList<>();
    try (BenchRegistrar reggie = new BenchRegistrar(ROBOT_LEASE)) {
      try {
        CountDownLatch joined = new CountDownLatch(JOINED);
        for (int i = 0; i < JOINED; i++) {
          BenchModule module = BenchModule.of(i);
          joins.add(
              LookupJoin.start(
                  module,
                  module.id(),
                  Entries.toEntries(module.attributes(i)),
                  List.of(),
                  List.of(reggie.locator()),
                  EmptyConfiguration.INSTANCE));
        }
        try (JiniModuleDirectory directory =
                new JiniModuleDirectory(BenchRegistrar.HOST, List.of(), List.of(reggie.locator()));
            DirectoryRegistration watch =
                directory.listen(ModuleQuery.of(Module.class), each -> joined.countDown())) {
          if (!joined.await(1, TimeUnit.MINUTES)) {
            throw new IOException(joined.getCount() + " modules did not join; " + watch);
          }
        }
        long before = reggie.bytes();
        long began = System.nanoTime();
        // No condition to wait for: the benchmark measures over this interval.
        new CountDownLatch(1).await(2 * ROBOT_LEASE, TimeUnit.MILLISECONDS);
        double seconds = (System.nanoTime() - began) / 1e9;
        report.figure(
            "renewal traffic of one module at one lookup service",
            (reggie.bytes() - before) / seconds / JOINED,
            "B/s");
      } finally {
        joins.forEach(LookupJoin::close);
      }
    }
  }
}
