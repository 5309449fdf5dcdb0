package org.dfra.river.proxy;

import java.io.Serializable;
import java.rmi.RemoteException;
import org.jspecify.annotations.Nullable;

/** A constant of a module, queried at its first use. A serialized proxy omits the value. */
final class Cached<T> implements Serializable {

  private static final long serialVersionUID = 1L;

  private transient volatile @Nullable T value;

  /** Queries the constant. */
  @FunctionalInterface
  interface RemoteSupplier<T> {
    T ask() throws RemoteException;
  }

  T get(RemoteSupplier<T> question) throws RemoteException {
    @Nullable T known = value;
    if (known == null) {
      known = question.ask();
      value = known;
    }
    return known;
  }
}
