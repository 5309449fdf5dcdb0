package org.dfra.activation.oldpeer;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.rmi.server.ObjID;
import java.rmi.server.UID;

/**
 * The serial form of {@code java.rmi.activation.ActivationID}, field by field. Its simple name must
 * be the same, for a stream to be resolved to it.
 */
public final class ActivationID implements Serializable {

  private static final long serialVersionUID = -4608673054848209235L;

  public transient UID uid;
  public transient String refClass;
  public transient byte format;
  public transient String host;
  public transient int port;
  public transient Object factory;
  public transient ObjID object;

  private void writeObject(ObjectOutputStream out) throws IOException {
    out.writeObject(uid);
    out.writeUTF(refClass);
    if (refClass.equals("UnicastRef2")) {
      out.writeByte(format);
    }
    out.writeUTF(host);
    out.writeInt(port);
    if (format == 1) {
      out.writeObject(factory);
    }
    object.write(out);
    out.writeBoolean(false);
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    uid = (UID) in.readObject();
    refClass = in.readUTF();
    format = refClass.equals("UnicastRef2") ? in.readByte() : 0;
    host = in.readUTF();
    port = in.readInt();
    factory = format == 1 ? in.readObject() : null;
    object = ObjID.read(in);
    if (in.readBoolean()) {
      throw new IOException("a plain stream ends with false");
    }
  }
}
