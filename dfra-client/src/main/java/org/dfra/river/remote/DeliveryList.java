package org.dfra.river.remote;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleListener;
import org.jspecify.annotations.Nullable;

/** The events of one remote call, which another program sent. */
public final class DeliveryList {

  private DeliveryList() {}

  /**
   * Checks a list as received: it may be of any class, and may contain any object.
   *
   * @return an unmodifiable copy
   * @throws IllegalArgumentException if it is not a list of the JDK, or not of 1 to {@value
   *     RemoteModuleListener#MAX_EVENTS} events
   */
  public static List<Delivery> checked(@Nullable List<?> received) {
    if (received == null || !isOfTheJdk(received.getClass())) {
      throw new IllegalArgumentException(
          "a listener is notified of a list of events, and this is none of the JDK's: "
              + (received == null ? null : received.getClass().getName()));
    }
    int count = received.size();
    if (count < 1 || count > RemoteModuleListener.MAX_EVENTS) {
      throw new IllegalArgumentException(
          count
              + " events in one call are outside 1 to "
              + RemoteModuleListener.MAX_EVENTS
              + "; send them in several calls");
    }
    List<Delivery> checked = new ArrayList<>(count);
    for (Object each : received) {
      if (!(each instanceof Delivery delivery)) {
        throw new IllegalArgumentException(
            "a listener is notified of events, and this is none: "
                + (each == null ? null : each.getClass().getName()));
      }
      checked.add(delivery);
    }
    return List.copyOf(checked);
  }

  private static boolean isOfTheJdk(Class<?> type) {
    return type.getClassLoader() == null && type.getPackageName().equals("java.util");
  }

  /** Notifies a listener of each, as {@link RemoteModuleListener} describes. */
  static void notifyOfEach(ModuleListener listener, List<Delivery> deliveries)
      throws RemoteException {
    @Nullable Throwable first = null;
    for (Delivery each : deliveries) {
      try {
        listener.notify(each);
      } catch (RemoteException | RuntimeException | Error e) {
        if (first == null) {
          first = e;
        } else if (first != e) {
          first.addSuppressed(e);
        }
      }
    }
    if (first instanceof RemoteException e) {
      throw e;
    } else if (first instanceof RuntimeException e) {
      throw e;
    } else if (first instanceof Error e) {
      throw e;
    }
  }
}
