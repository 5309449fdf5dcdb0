package org.dfra.river.phoenix;

import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.Activator;
import java.rmi.server.UID;
import net.jini.security.proxytrust.TrustEquivalence;
import org.jspecify.annotations.Nullable;

/**
 * The activation ID of an object under this daemon.
 *
 * <p>The standard serial form of {@link ActivationID} supports only a JRMP activator, so this class
 * serializes itself as a record of its two parts. The class must come from one loader everywhere
 * (the class path), or two equal IDs would not be equal.
 *
 * <p>Each proxy that activates its server again contains one, so clients download it. It stays in
 * the daemon's package because its name is in journals, in logs of registrars and in stored
 * proxies.
 */
public final class JeriActivationID extends ActivationID implements TrustEquivalence {

  private static final long serialVersionUID = 1L;

  private final transient Activator activator;
  private final transient UID uid;

  JeriActivationID(Activator activator, UID uid) {
    super(activator);
    this.activator = activator;
    this.uid = uid;
  }

  /** The daemon's identifier of the object. */
  UID uid() {
    return uid;
  }

  @Override
  public Remote activate(boolean force) throws ActivationException, RemoteException {
    try {
      return activator.activate(this, force).get();
    } catch (java.io.IOException | ClassNotFoundException e) {
      if (e instanceof RemoteException remote) {
        throw remote;
      }
      throw new java.rmi.UnmarshalException("the activated object's proxy cannot be read", e);
    }
  }

  @Override
  public boolean checkTrustEquivalence(@Nullable Object other) {
    return other instanceof JeriActivationID id
        && uid.equals(id.uid)
        && activator instanceof TrustEquivalence trusted
        && trusted.checkTrustEquivalence(id.activator);
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof JeriActivationID id
        && uid.equals(id.uid)
        && activator.equals(id.activator);
  }

  @Override
  public int hashCode() {
    return uid.hashCode();
  }

  @Override
  public String toString() {
    return "activation ID " + uid;
  }

  private Object writeReplace() {
    return new Parts(activator, uid);
  }

  private void readObject(ObjectInputStream in) throws InvalidObjectException {
    throw new InvalidObjectException("an activation ID of this kind is written as its parts");
  }

  /** The serial form. */
  private record Parts(Activator activator, UID uid) implements Serializable {
    Parts {
      java.util.Objects.requireNonNull(activator, "activator");
      java.util.Objects.requireNonNull(uid, "uid");
    }

    private Object readResolve() {
      return new JeriActivationID(activator, uid);
    }
  }
}
