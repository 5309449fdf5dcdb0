package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.sun.jini.thread.TaskManager;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import net.jini.config.ConfigurationException;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.security.ProxyPreparer;
import org.dfra.river.lookup.LookupJoin;
import org.dfra.river.lookup.SuppliedConfiguration;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;

/** What is closed while a lookup service registers it is taken out of it all the same. */
@Timeout(60)
class JoinCloseTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** A close that ends sooner than its patience of 1 s has awaited everything. */
  private static final Duration CERTAIN = Duration.ofMillis(500);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  private final UUID id = UUID.randomUUID();
  private final HeldAnswer held = new HeldAnswer();

  @AfterEach
  void release() {
    held.release.countDown();
  }

  @Test
  void takesBackARegistrationThatWasUnderWay() throws Exception {
    LookupJoin join = join(Map.of("net.jini.lookup.JoinManager.registrarPreparer", () -> held));
    held.granted.await();
    assertThat(registrations()).as("granted, but its answer is held").isEqualTo(1);

    Thread closing = new Thread(join::close, "closing");
    long began = System.nanoTime();
    closing.start();
    await().atMost(PATIENCE).until(() -> closing.getState() == Thread.State.TIMED_WAITING);
    assertThat(held.interrupted).as("the registration was interrupted").hasValue(0);
    held.release.countDown();
    closing.join();

    if (System.nanoTime() - began < CERTAIN.toNanos()) {
      assertThat(registrations()).as("after the close").isZero();
    } else { // the machine was slower than the close is patient
      await().atMost(PATIENCE).untilAsserted(() -> assertThat(registrations()).isZero());
    }
  }

  @Test
  void takesItBackLaterWhereTheCloserIsInAHurry() throws Exception {
    LookupJoin join = join(Map.of("net.jini.lookup.JoinManager.registrarPreparer", () -> held));
    held.granted.await();

    Thread.currentThread().interrupt();
    join.close();
    assertThat(Thread.interrupted()).as("still marked as interrupted").isTrue();
    assertThat(registrations()).as("its answer is still held").isEqualTo(1);
    held.release.countDown();

    await().atMost(PATIENCE).untilAsserted(() -> assertThat(registrations()).isZero());
  }

  @Test
  void closesTwice() throws Exception {
    LookupJoin join = join(Map.of());
    await().atMost(PATIENCE).until(() -> registrations() == 1);
    join.close();
    join.close();
    assertThat(registrations()).isZero();
  }

  @Test
  void usesTheThreadsThatAConfigurationNames() throws Exception {
    AtomicInteger counted = new AtomicInteger();
    TaskManager own =
        new TaskManager() {
          @Override
          public synchronized void add(Task task) {
            counted.incrementAndGet();
            super.add(task);
          }
        };
    try (LookupJoin join = join(Map.of("net.jini.lookup.JoinManager.taskManager", () -> own))) {
      await().atMost(PATIENCE).until(() -> registrations() == 1);
      assertThat(counted).as("tasks of " + join).hasPositiveValue();
    }
  }

  private LookupJoin join(Map<String, Supplier<?>> entries)
      throws IOException, ConfigurationException {
    return LookupJoin.start(
        "a service",
        id,
        new Entry[0],
        List.of(),
        List.of(REGGIE.locator()),
        new SuppliedConfiguration(entries));
  }

  private int registrations() throws IOException {
    ServiceID sought = new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits());
    return REGGIE.registrar().lookup(new ServiceTemplate(sought, null, null), 1).totalMatches;
  }

  /** A lookup service whose answer to a registration is held on its way back. */
  private static final class HeldAnswer implements ProxyPreparer {

    private final CountDownLatch granted = new CountDownLatch(1);
    private final CountDownLatch release = new CountDownLatch(1);
    private final AtomicInteger interrupted = new AtomicInteger();

    @Override
    public Object prepareProxy(Object registrar) {
      return Proxy.newProxyInstance(
          ServiceRegistrar.class.getClassLoader(),
          new Class<?>[] {ServiceRegistrar.class},
          (proxy, method, args) -> {
            Object answer = answer(registrar, method, args);
            if (method.getName().equals("register")) {
              granted.countDown();
              awaitRelease();
            }
            return answer;
          });
    }

    private static Object answer(Object registrar, Method method, Object[] args) throws Throwable {
      try {
        return method.invoke(registrar, args);
      } catch (InvocationTargetException e) {
        throw e.getCause();
      }
    }

    private void awaitRelease() {
      while (true) {
        try {
          release.await();
          return;
        } catch (InterruptedException e) {
          interrupted.incrementAndGet(); // a connection cannot be interrupted either
        }
      }
    }
  }
}
