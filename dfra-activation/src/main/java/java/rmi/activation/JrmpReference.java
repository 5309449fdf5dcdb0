package java.rmi.activation;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InvalidObjectException;
import java.io.ObjectInput;
import java.io.ObjectInputStream;
import java.io.ObjectOutput;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.server.ObjID;
import java.rmi.server.RMIClientSocketFactory;
import java.rmi.server.RemoteObject;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.rmi.server.RemoteRef;

/**
 * A JRMP reference as {@link ActivationID} writes and reads it: its class name, then its external
 * form.
 *
 * <p>The reference classes are internal to the JDK and can no longer be constructed by name. But
 * the same bytes, in the same order, are also the public serial form of a {@link RemoteObject}. So
 * the bytes are read as documented there, rewritten as a remote invocation handler's, and
 * deserialized by the JDK.
 */
final class JrmpReference {

  private final RemoteRef ref;

  private JrmpReference(RemoteRef ref) {
    this.ref = ref;
  }

  /** The reference in a JRMP stub, or in the stub of an object exported by JRMP in this JVM. */
  static JrmpReference of(Remote remote) throws InvalidObjectException {
    Remote stub = remote;
    try {
      stub = remote == null ? null : RemoteObject.toStub(remote);
    } catch (NoSuchObjectException e) {
      // Not exported by JRMP: reported below, with its class.
    }
    if (stub instanceof RemoteObject object && object.getRef() != null) {
      return new JrmpReference(object.getRef());
    }
    if (stub != null
        && Proxy.isProxyClass(stub.getClass())
        && Proxy.getInvocationHandler(stub) instanceof RemoteObjectInvocationHandler handler) {
      return new JrmpReference(handler.getRef());
    }
    throw new InvalidObjectException(
        "An ActivationID can be written only with an activator exported by JRMP, not with "
            + (remote == null ? "null" : "a " + remote.getClass().getName())
            + ": use a subclass of ActivationID with a writeReplace method.");
  }

  void write(ObjectOutput out) throws IOException {
    out.writeUTF(ref.getRefClass(out));
    ref.writeExternal(out);
  }

  <T extends Remote> T proxy(Class<T> type) {
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(), new Class<?>[] {type}, new RemoteObjectInvocationHandler(ref)));
  }

  /** Reads what {@link #write} wrote, on this or any older release. */
  static JrmpReference read(ObjectInput in) throws IOException, ClassNotFoundException {
    String refClass = in.readUTF();
    boolean second = refClass.equals("UnicastRef2");
    if (!second && !refClass.equals("UnicastRef")) {
      throw new InvalidObjectException(
          "An ActivationID was read whose activator has a reference of class \""
              + refClass
              + "\": known are UnicastRef and UnicastRef2.");
    }
    byte format = second ? in.readByte() : 0;
    if (format != 0 && format != 1) {
      throw new InvalidObjectException(
          "An ActivationID was read whose activator's endpoint has format "
              + format
              + ": known are 0 (without) and 1 (with a socket factory).");
    }
    String host = in.readUTF();
    int port = in.readInt();
    RMIClientSocketFactory factory = format == 1 ? (RMIClientSocketFactory) in.readObject() : null;
    ObjID id = ObjID.read(in);
    in.readBoolean();
    return rebuild(
        refClass,
        out -> {
          if (second) {
            out.writeByte(format);
          }
          out.writeUTF(host);
          out.writeInt(port);
          if (format == 1) {
            out.writeObject(new Placeholder());
          }
          id.write(out);
          out.writeBoolean(false);
        },
        factory);
  }

  private interface ExternalForm {
    void writeTo(ObjectOutput out) throws IOException;
  }

  private static JrmpReference rebuild(
      String refClass, ExternalForm form, RMIClientSocketFactory factory)
      throws IOException, ClassNotFoundException {
    InvocationHandler written =
        (proxy, method, args) ->
            switch (method.getName()) {
              case "getRefClass" -> refClass;
              case "writeExternal" -> {
                form.writeTo((ObjectOutput) args[0]);
                yield null;
              }
              // Serialization calls no other method.
              default -> throw new UnsupportedOperationException(method.toString());
            };
    RemoteRef replay =
        (RemoteRef) Proxy.newProxyInstance(null, new Class<?>[] {RemoteRef.class}, written);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(new RemoteObjectInvocationHandler(replay));
    }
    try (ObjectInputStream in =
        new Resolving(new ByteArrayInputStream(bytes.toByteArray()), factory)) {
      return new JrmpReference(((RemoteObject) in.readObject()).getRef());
    }
  }

  /** Replaces the socket factory, whose class the second read might not find. */
  private static final class Placeholder implements Serializable {
    private static final long serialVersionUID = 1L;
  }

  private static final class Resolving extends ObjectInputStream {

    private final RMIClientSocketFactory factory;

    Resolving(InputStream in, RMIClientSocketFactory factory) throws IOException {
      super(in);
      this.factory = factory;
      enableResolveObject(true);
    }

    @Override
    protected Object resolveObject(Object read) {
      return read instanceof Placeholder ? factory : read;
    }
  }
}
