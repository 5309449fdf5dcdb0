package java.rmi.activation;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.UnmarshalException;
import java.rmi.server.UID;
import java.util.Objects;

/**
 * The identity of a registered object: unique, with a reference to the activator that can start it.
 *
 * <p>The serial form supports only an activator exported by JRMP. A system whose activator is
 * exported otherwise (JERI) issues a subclass with a {@code writeReplace}, and overrides {@link
 * #equals}, {@link #hashCode} and {@link #activate} as it needs.
 */
public class ActivationID implements Serializable {

  private static final long serialVersionUID = -4608673054848209235L;

  private transient Activator activator;
  private transient UID uid = new UID();

  /**
   * A new identity, different from all others.
   *
   * @param activator the activator that {@link #activate} calls
   */
  public ActivationID(Activator activator) {
    this.activator = activator;
  }

  /**
   * Starts the object if it is not running, and returns its proxy.
   *
   * @param force false: the activator may return a cached proxy; true: that proxy failed, so the
   *     activator asks the object's group
   * @return the object's proxy
   * @throws ActivationException if the object or its group cannot be started
   * @throws UnknownObjectException if the object is not registered with the activator
   * @throws UnmarshalException if the returned proxy cannot be unmarshalled here
   * @throws RemoteException if the call to the activator fails
   */
  public Remote activate(boolean force)
      throws ActivationException, UnknownObjectException, RemoteException {
    MarshalledObject<? extends Remote> marshalled = activator.activate(this, force);
    if (marshalled == null) {
      throw new ActivationException("The activator answered without a proxy: " + activator);
    }
    try {
      return Remote.class.cast(marshalled.get());
    } catch (RemoteException e) {
      throw e;
    } catch (IOException | ClassNotFoundException | ClassCastException e) {
      throw new UnmarshalException(
          "The object was activated but its proxy cannot be unmarshalled here", e);
    }
  }

  /**
   * Computed from the unique part alone.
   *
   * @return equal for equal identities
   */
  @Override
  public int hashCode() {
    return Objects.hashCode(uid);
  }

  /**
   * Whether both name the same object of the same activator.
   *
   * @param other anything
   * @return true for an ActivationID with equal unique part and equal activator
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof ActivationID that
        && Objects.equals(uid, that.uid)
        && Objects.equals(activator, that.activator);
  }

  /**
   * Writes the identity without default fields.
   *
   * @serialData the {@link UID} with {@code writeObject}; the class name of the activator's JRMP
   *     reference without its package with {@code writeUTF}; then that reference's external form,
   *     as the serialized form of {@link java.rmi.server.RemoteObject} describes it
   */
  private void writeObject(ObjectOutputStream out) throws IOException {
    JrmpReference reference = JrmpReference.of(activator);
    out.writeObject(uid);
    reference.write(out);
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    uid = (UID) in.readObject();
    if (uid == null) {
      throw new InvalidObjectException("An ActivationID was read without its unique part.");
    }
    activator = JrmpReference.read(in).proxy(Activator.class);
  }
}
