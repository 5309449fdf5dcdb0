package java.rmi.activation;

import java.lang.reflect.Method;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.UnexpectedException;
import java.rmi.server.RemoteRef;

/**
 * The JRMP stub of a group, found by JRMP through its name.
 *
 * <p>Older releases list it in their public API and exchange it by name, so it is kept.
 * Applications do not construct it.
 */
@SuppressWarnings({"deprecation", "rawtypes", "unchecked"})
public final class ActivationGroup_Stub extends java.rmi.server.RemoteStub
    implements ActivationInstantiator, Remote {

  private static final long serialVersionUID = 2L;

  /** JRMP's hash of the method below: the start of the SHA-1 of its name and descriptor. */
  private static final long NEW_INSTANCE_HASH = -5274445189091581345L;

  private static final Method NEW_INSTANCE = newInstanceMethod();

  /**
   * A stub of the group behind a reference.
   *
   * @param ref the reference to the group
   */
  public ActivationGroup_Stub(RemoteRef ref) {
    super(ref);
  }

  private static Method newInstanceMethod() {
    try {
      return ActivationInstantiator.class.getMethod(
          "newInstance", ActivationID.class, ActivationDesc.class);
    } catch (NoSuchMethodException e) {
      throw new LinkageError("ActivationInstantiator.newInstance is missing", e);
    }
  }

  /**
   * Calls the group.
   *
   * @param id the object's identity
   * @param desc class, location and initialisation data
   * @return the object's proxy, marshalled
   * @throws RemoteException if the call fails
   * @throws ActivationException if the object cannot be constructed
   */
  @Override
  public MarshalledObject newInstance(ActivationID id, ActivationDesc desc)
      throws RemoteException, ActivationException {
    try {
      return (MarshalledObject)
          ref.invoke(this, NEW_INSTANCE, new Object[] {id, desc}, NEW_INSTANCE_HASH);
    } catch (RuntimeException | RemoteException | ActivationException e) {
      throw e;
    } catch (Exception e) { // as RemoteRef declares it
      throw new UnexpectedException(
          "The group threw an exception that its method does not declare", e);
    }
  }
}
