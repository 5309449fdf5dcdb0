package org.dfra.core.chain;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.module.Module;

/**
 * The inputs of one link of a chain: it listens to the modules it is wired to and takes the newest
 * reading of each. Wiring it anew ends the old ties when the new ones hold; where one cannot be
 * made, the old ones stay.
 */
public final class ChainInputs implements AutoCloseable {

  /** Takes what comes in. */
  @FunctionalInterface
  public interface Taker {

    /**
     * Takes a reading; on a delivery thread, one at a time for each input.
     *
     * @param input which input, from 0
     */
    void take(int input, Reading reading);
  }

  private final String module;
  private final Function<String, Optional<? extends Module>> directory;
  private final Taker taker;
  private List<Subscription> ties = List.of(); // guarded by this

  /**
   * @param module whose inputs these are, for messages
   * @param directory finds a module by its path
   */
  public ChainInputs(
      String module, Function<String, Optional<? extends Module>> directory, Taker taker) {
    this.module = module;
    this.directory = directory;
    this.taker = taker;
  }

  /**
   * Listens to these modules from now on, and to no others.
   *
   * @throws IllegalArgumentException if one is not found or cannot be reached
   */
  public synchronized void wire(List<String> modules) {
    List<Subscription> fresh = new ArrayList<>();
    try {
      for (int i = 0; i < modules.size(); i++) {
        fresh.add(tie(i, modules.get(i)));
      }
    } catch (IllegalArgumentException e) {
      fresh.forEach(Subscription::close);
      throw e;
    }
    List<Subscription> old = ties;
    ties = fresh;
    old.forEach(Subscription::close);
  }

  private Subscription tie(int input, String path) {
    Module source =
        directory
            .apply(path)
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        module + " cannot be wired to " + path + ": there is no such module"));
    try {
      return source.subscribe(delivery -> take(input, delivery), DeliveryPolicy.latestReading());
    } catch (RemoteException e) {
      throw new IllegalArgumentException(
          module + " cannot be wired to " + path + ": it cannot be reached", e);
    }
  }

  private void take(int input, Delivery delivery) {
    if (delivery.event() instanceof ModuleEvent.NewReading fresh) {
      taker.take(input, fresh.reading());
    }
  }

  /** Listens to nothing any more. */
  @Override
  public synchronized void close() {
    ties.forEach(Subscription::close);
    ties = List.of();
  }
}
