package org.dfra.core.directory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A listener is notified of every change, whatever failed before. */
@Timeout(60)
class ListenerNotifierTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final UUID id = UUID.randomUUID();
  private final List<String> notified = new CopyOnWriteArrayList<>();

  private static final class Lamp extends ModuleImpl {
    Lamp() {
      super(
          new ModuleContext(
              "atrv1",
              "lamp",
              Parameters.of("atrv1/lamp", Map.of()),
              InstantSource.system(),
              StateStore.inMemory()),
          "a lamp",
          "DFRA",
          "1");
    }

    @Override
    protected void onStart() {}

    @Override
    protected void onClose() {}
  }

  private ListenerNotifier<Module> feed(Executor threads, DirectoryListener<Module> listener) {
    try (InMemoryModuleDirectory directory = new InMemoryModuleDirectory();
        Lamp lamp = new Lamp()) {
      Object unused = directory.add(lamp);
      ModuleListing<Module> listing = directory.find(ModuleQuery.of(Module.class)).get(0);
      return new ListenerNotifier<>(
          module -> module.equals(id) ? listing : null,
          listener,
          threads,
          Scheduler.system(),
          closed -> {});
    }
  }

  @Test
  void aChangeArrivesThoughNoThreadCouldBeStartedWhenItHappened() {
    AtomicInteger refusals = new AtomicInteger(2);
    Executor threads =
        task -> {
          if (refusals.getAndDecrement() > 0) {
            throw new OutOfMemoryError("unable to create native thread");
          }
          new Thread(task, "listener").start();
        };
    ListenerNotifier<Module> feed = feed(threads, new Notes(false));
    feed.accept(id);
    await().atMost(PATIENCE).untilAsserted(() -> assertThat(notified).containsExactly("matched"));
    feed.close();
  }

  @Test
  void anErrorInAListenerDoesNotKeepItFromTheNextChange() {
    List<Runnable> held = new CopyOnWriteArrayList<>();
    ListenerNotifier<Module> feed = feed(held::add, new Notes(true));
    feed.accept(id);
    held.get(0).run();
    assertThat(notified).containsExactly("matched");
    feed.accept(UUID.randomUUID());
    assertThat(held).as("a thread is asked for again").hasSize(2);
    feed.close();
  }

  /** Writes down what comes. */
  private final class Notes implements DirectoryListener<Module> {

    private final boolean fails;

    Notes(boolean fails) {
      this.fails = fails;
    }

    @Override
    public void matched(ModuleListing<Module> listing) {
      notified.add("matched");
      if (fails) {
        throw new StackOverflowError("a fault in the listener");
      }
    }

    @Override
    public void changed(ModuleListing<Module> before, ModuleListing<Module> now) {
      notified.add("changed");
    }

    @Override
    public void unmatched(ModuleListing<Module> last) {
      notified.add("unmatched");
    }
  }
}
