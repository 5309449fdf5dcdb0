package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.entry.Entries;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.lookup.EffectorSearch.ListedEffector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What is read of a lookup service for an emergency. */
@Timeout(60)
class RegistrarEffectorReaderTest {

  private final BlockingQueue<ListedEffector> found = new LinkedBlockingQueue<>();
  private final Semaphore over = new Semaphore(0);
  private final CountDownLatch end = new CountDownLatch(1);

  private final EffectorSearch.Listener listener =
      new EffectorSearch.Listener() {
        @Override
        public void registrarFound(UUID registrar, String host) {}

        @Override
        public void found(ListedEffector effector) {
          found.add(effector);
        }
      };

  private final AtomicInteger lookups = new AtomicInteger();

  /**
   * One that claims the same service ID as every other one, and lists one effector.
   *
   * @param unanswered how often it does not answer when it is asked for effectors
   */
  private ServiceRegistrar registrar(int unanswered) {
    ModuleAttributes drive =
        new ModuleAttributes(
            "atrv1",
            "drive",
            "org.example.Driver",
            "127.0.0.1",
            "DFRA",
            "1.0",
            Readiness.READY,
            Instant.EPOCH,
            null,
            0);
    ServiceItem item =
        new ServiceItem(new ServiceID(0, 99), null, Entries.toEntries(List.of(drive)));
    return (ServiceRegistrar)
        Proxy.newProxyInstance(
            ServiceRegistrar.class.getClassLoader(),
            new Class<?>[] {ServiceRegistrar.class},
            (proxy, method, args) ->
                switch (method.getName()) {
                  case "getServiceID" -> new ServiceID(0, 7);
                  case "lookup" -> {
                    if (lookups.incrementAndGet() <= unanswered) {
                      throw new DeadlineExceededException("lookup", Duration.ofSeconds(2), true);
                    }
                    yield new ServiceMatches(new ServiceItem[] {item}, 1);
                  }
                  default -> null;
                });
  }

  private RegistrarEffectorReader reading() {
    return reading(0, () -> false);
  }

  private RegistrarEffectorReader reading(int unanswered, BooleanSupplier isTimeLeft) {
    return new RegistrarEffectorReader(
        registrar(unanswered),
        List.of("atrv1"),
        List.of(),
        listener,
        null,
        over::release,
        isTimeLeft);
  }

  private void awaitEnd(RegistrarEffectorReader reading) throws InterruptedException {
    while (!reading.isOver()) {
      assertThat(over.tryAcquire(30, TimeUnit.SECONDS)).isTrue();
    }
  }

  /**
   * One that lists the robots atrv1 and atrv2, and keeps to itself until it is closed what it is
   * asked in one way.
   *
   * @param held the method, and the robot that it is asked about, if any: {@code lookup atrv1}
   */
  private ServiceRegistrar holding(String held) {
    ServiceRegistrar all = registrar(0);
    return (ServiceRegistrar)
        Proxy.newProxyInstance(
            ServiceRegistrar.class.getClassLoader(),
            new Class<?>[] {ServiceRegistrar.class},
            (proxy, method, args) -> {
              String asked = method.getName();
              if (asked.equals("lookup")) {
                ServiceTemplate template = (ServiceTemplate) args[0];
                asked += " " + ((ModuleEntry) template.attributeSetTemplates[0]).robot;
              }
              if (asked.equals(held)) {
                end.await();
                throw new RemoteException("too late");
              }
              return asked.equals("getFieldValues")
                  ? new Object[] {"atrv1", "atrv2"}
                  : method.invoke(all, args);
            });
  }

  /** Anybody may list thousands of robots before them. */
  @Test
  void robotsThatAreKnownAreReadBeforeTheOthersAreListed() throws Exception {
    try (RegistrarEffectorReader reading =
        new RegistrarEffectorReader(
            holding("getFieldValues"),
            List.of(),
            List.of("atrv1"),
            listener,
            null,
            () -> {},
            () -> false)) {
      reading.start();
      assertThat(found.poll(30, TimeUnit.SECONDS)).isNotNull();
    } finally {
      end.countDown();
    }
  }

  /** A stop of one robot must not wait for the list of all. */
  @Test
  void robotsThatAreWantedAreReadWithoutAList() throws Exception {
    try (RegistrarEffectorReader reading =
        new RegistrarEffectorReader(
            holding("getFieldValues"),
            List.of("atrv1"),
            List.of(),
            listener,
            null,
            over::release,
            () -> false)) {
      reading.start();
      assertThat(found.poll(30, TimeUnit.SECONDS)).isNotNull();
      awaitEnd(reading);
    } finally {
      end.countDown();
    }
  }

  @Test
  void anAnswerThatDoesNotComeDelaysNoOtherRobot() throws Exception {
    try (RegistrarEffectorReader reading =
        new RegistrarEffectorReader(
            holding("lookup atrv1"), List.of(), List.of(), listener, null, () -> {}, () -> false)) {
      reading.start();
      assertThat(found.poll(30, TimeUnit.SECONDS)).as("of atrv2").isNotNull();
      assertThat(reading.isOver()).isFalse();
    } finally {
      end.countDown();
    }
  }

  @Test
  void whatIsNotAnsweredIsAskedTwice() throws Exception {
    try (RegistrarEffectorReader reading = reading(1, () -> false)) {
      reading.start();
      assertThat(found.poll(30, TimeUnit.SECONDS)).isNotNull();
      awaitEnd(reading);
      assertThat(reading.unread()).isEmpty();
    }
  }

  /** As many as there are threads, of robots that are listed before it. */
  @Test
  void robotsThatDoNotAnswerAreAskedAgainAfterAllOthers() throws Exception {
    List<String> asked = new CopyOnWriteArrayList<>();
    ServiceRegistrar all = registrar(0);
    ServiceRegistrar slow =
        (ServiceRegistrar)
            Proxy.newProxyInstance(
                ServiceRegistrar.class.getClassLoader(),
                new Class<?>[] {ServiceRegistrar.class},
                (proxy, method, args) -> {
                  if (!method.getName().equals("lookup")) {
                    return method.invoke(all, args);
                  }
                  ServiceTemplate template = (ServiceTemplate) args[0];
                  String robot = ((ModuleEntry) template.attributeSetTemplates[0]).robot;
                  asked.add(robot);
                  if (robot.startsWith("mute")) {
                    throw new DeadlineExceededException("lookup", Duration.ofSeconds(2), true);
                  }
                  return method.invoke(all, args);
                });
    try (RegistrarEffectorReader reading =
        new RegistrarEffectorReader(
            slow,
            List.of("mute1", "mute2", "mute3", "mute4", "mute5", "atrv1"),
            List.of(),
            listener,
            null,
            over::release,
            () -> false)) {
      reading.start();
      awaitEnd(reading);
    }
    assertThat(found).hasSize(1);
    assertThat(asked).hasSize(11);
    assertThat(asked.subList(0, 6)).as("once each").contains("mute1", "mute5", "atrv1");
  }

  /** Of an overloaded computer, for whose answers the operator is willing to wait. */
  @Test
  void whatIsNotAnsweredIsAskedAgainWhileThereIsTime() throws Exception {
    try (RegistrarEffectorReader reading = reading(3, () -> lookups.get() <= 3)) {
      reading.start();
      assertThat(found.poll(30, TimeUnit.SECONDS)).isNotNull();
      awaitEnd(reading);
      assertThat(reading.unread()).isEmpty();
    }
  }

  @Test
  void whatIsNeverAnsweredIsNamedWhenTheTimeIsOver() throws Exception {
    try (RegistrarEffectorReader reading = reading(Integer.MAX_VALUE, () -> lookups.get() < 3)) {
      reading.start();
      awaitEnd(reading);
      assertThat(lookups).hasValue(3);
      assertThat(found).isEmpty();
      assertThat(reading.unread())
          .singleElement()
          .asString()
          .endsWith(" was called: it did not answer (DeadlineExceededException)");
    }
  }

  /** A stranger's lookup service may list any number of them, each of which would be called. */
  @Test
  void ofManyEffectorsOfOneNameAFewAreReadAndTheOthersNamed() throws Exception {
    int many = 100;
    List<Integer> asked = new CopyOnWriteArrayList<>();
    ServiceItem item = registrar(0).lookup(new ServiceTemplate(null, null, null), 1).items[0];
    ServiceRegistrar crowded =
        (ServiceRegistrar)
            Proxy.newProxyInstance(
                ServiceRegistrar.class.getClassLoader(),
                new Class<?>[] {ServiceRegistrar.class},
                (proxy, method, args) ->
                    switch (method.getName()) {
                      case "getServiceID" -> new ServiceID(0, 7);
                      case "getFieldValues" -> new Object[] {"drive"};
                      case "lookup" -> {
                        ServiceTemplate template = (ServiceTemplate) args[0];
                        if (((ModuleEntry) template.attributeSetTemplates[0]).name == null) {
                          yield new ServiceMatches(new ServiceItem[0], many);
                        }
                        int most = (Integer) args[1];
                        asked.add(most);
                        ServiceItem[] items = new ServiceItem[Math.min(most, many)];
                        Arrays.fill(items, item);
                        yield new ServiceMatches(items, many);
                      }
                      default -> null;
                    });
    try (RegistrarEffectorReader reading =
        new RegistrarEffectorReader(
            crowded, List.of("atrv1"), List.of(), listener, null, over::release, () -> false)) {
      reading.start();
      awaitEnd(reading);
      assertThat(asked).containsExactly(8);
      assertThat(found).hasSize(8);
      assertThat(reading.unread())
          .singleElement()
          .asString()
          .endsWith(" was called: it lists 100 effectors atrv1/drive, of which 8 were called");
    }
  }

  @Test
  void whatLookupServicesOfOneServiceIdListIsKeptSeparate() throws Exception {
    try (RegistrarEffectorReader one = reading();
        RegistrarEffectorReader two = reading()) {
      one.start();
      two.start();
      ListedEffector first = found.poll(30, TimeUnit.SECONDS);
      ListedEffector second = found.poll(30, TimeUnit.SECONDS);
      assertThat(first).isNotNull();
      assertThat(second).isNotNull();
      assertThat(first.id()).isEqualTo(second.id());
      assertThat(first.registrar())
          .as("or only one would be called")
          .isNotEqualTo(second.registrar());
    }
  }
}
