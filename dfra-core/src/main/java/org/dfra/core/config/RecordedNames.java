package org.dfra.core.config;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.ObjectStreamConstants;
import java.io.UncheckedIOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;

/**
 * Replaces old names of classes, interfaces and record components in serialized objects that this
 * computer recorded: in class descriptors, and in marshalled objects inside them.
 *
 * <p>Names are replaced in the bytes, since a marshalled object is unmarshalled by a stream of the
 * JDK, which no subclass can extend. The grammar of these bytes is the Java Object Serialization
 * Specification, section 6.4.
 */
public final class RecordedNames {

  /** Scope of types; a type's nested types follow it. */
  private static final String TYPES = "recorded type";

  /** Scope of a record's components, with its new name. */
  private static final String COMPONENTS = "component ";

  private static final int HEADER = 0xACED0005; // magic number and version
  private static final int SUID_AND_FLAGS = Long.BYTES + 1;
  private static final int MAX_INTERFACES = 64;

  /** How the names of all recorded types begin. */
  private static final byte[] PACKAGE = "org.dfra.".getBytes(StandardCharsets.UTF_8);

  private final byte[] stream;
  private final ByteBuffer in;
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final DataOutputStream out = new DataOutputStream(bytes);
  private int copied; // of the stream's bytes: these, or what replaces them, are in the output

  private RecordedNames(byte[] stream) {
    this.stream = stream;
    this.in = ByteBuffer.wrap(stream);
  }

  /**
   * The same object stream with new names.
   *
   * @param stream an object stream from its first byte
   * @return the given array if it contains no old name, or ends inside a class descriptor: then
   *     nobody can read it
   */
  public static byte[] translate(byte[] stream) {
    try {
      return new RecordedNames(stream).translate();
    } catch (BufferUnderflowException e) {
      return stream;
    } catch (IOException e) {
      throw new UncheckedIOException(e); // writing to memory does not fail
    }
  }

  private byte[] translate() throws IOException {
    for (int at = 0; at < stream.length; at++) {
      if (mayBegin(at) && isReplaced(at)) {
        at = in.position() - 1;
      }
    }
    if (copied == 0) {
      return stream;
    }
    copyUpTo(stream.length);
    return bytes.toByteArray();
  }

  /** Whether a name or an object stream may follow. Nearly all bytes are ruled out here. */
  private boolean mayBegin(int at) {
    return switch (stream[at]) {
      case ObjectStreamConstants.TC_CLASSDESC -> namesOurType(at + 1 + Short.BYTES);
      case ObjectStreamConstants.TC_PROXYCLASSDESC -> true;
      case (byte) (HEADER >>> 24) -> at >= Integer.BYTES && isHeader(at);
      default -> false;
    };
  }

  private boolean namesOurType(int from) {
    int to = from + PACKAGE.length;
    return to <= stream.length && Arrays.equals(stream, from, to, PACKAGE, 0, PACKAGE.length);
  }

  private boolean isHeader(int at) {
    return at + Integer.BYTES <= stream.length && in.getInt(at) == HEADER;
  }

  /** Whether what is here was read; where it has old names, it is replaced too. */
  private boolean isReplaced(int at) throws IOException {
    in.position(at + 1);
    return switch (stream[at]) {
      case ObjectStreamConstants.TC_CLASSDESC -> isDescriptor(at);
      case ObjectStreamConstants.TC_PROXYCLASSDESC -> isProxyDescriptor(at);
      default -> isArrayOfStream(at);
    };
  }

  private void copyUpTo(int end) throws IOException {
    out.write(stream, copied, end - copied);
    copied = end;
  }

  /** A class descriptor, up to its fields, whose class or one of whose fields has a new name. */
  private boolean isDescriptor(int at) throws IOException {
    String name = name();
    String now = type(name);
    if (now.equals(name) && !RenamedNames.hasScope(COMPONENTS + now)
        || in.remaining() < SUID_AND_FLAGS + Short.BYTES) {
      return false;
    }
    copyUpTo(at + 1);
    out.writeUTF(now);
    copy(SUID_AND_FLAGS);
    int fields = in.getShort();
    out.writeShort(fields);
    for (int i = 0; i < fields; i++) {
      byte kind = in.get();
      out.write(kind);
      String field = name();
      out.writeUTF(RenamedNames.find(COMPONENTS + now, field).orElse(field));
      if (kind == 'L' || kind == '[') {
        copyTypeName();
      }
    }
    copied = in.position();
    return true;
  }

  private void copyTypeName() throws IOException {
    byte code = in.get();
    out.write(code);
    if (code == ObjectStreamConstants.TC_STRING) {
      out.writeUTF(name());
    } else {
      copy(Integer.BYTES); // a reference to an earlier string
    }
  }

  /** A dynamic proxy's interfaces, one of which has a new name. */
  private boolean isProxyDescriptor(int at) throws IOException {
    if (in.remaining() < Integer.BYTES) {
      return false;
    }
    int interfaces = in.getInt();
    if (interfaces < 1 || interfaces > MAX_INTERFACES) {
      return false;
    }
    String[] names = new String[interfaces];
    boolean isRenamed = false;
    for (int i = 0; i < interfaces; i++) {
      String name = name();
      names[i] = type(name);
      if (name.isEmpty()) {
        return false;
      }
      isRenamed |= !names[i].equals(name);
    }
    if (!isRenamed) {
      return false;
    }
    copyUpTo(at + 1);
    out.writeInt(interfaces);
    for (String each : names) {
      out.writeUTF(each);
    }
    copied = in.position();
    return true;
  }

  /**
   * The content of an array of bytes, which is an object stream itself, such as a marshalled
   * object's.
   */
  private boolean isArrayOfStream(int at) throws IOException {
    int length = in.getInt(at - Integer.BYTES);
    if (length < Integer.BYTES || length > stream.length - at || copied > at - Integer.BYTES) {
      return false;
    }
    byte[] array = Arrays.copyOfRange(stream, at, at + length);
    byte[] translated = translate(array);
    in.position(at + length);
    if (translated != array) {
      copyUpTo(at - Integer.BYTES);
      out.writeInt(translated.length);
      out.write(translated);
      copied = in.position();
    }
    return true;
  }

  /** The text at the present position, after its length; empty if there is none. */
  private String name() {
    if (in.remaining() < Short.BYTES) {
      return "";
    }
    int length = Short.toUnsignedInt(in.getShort());
    if (length > in.remaining()) {
      return "";
    }
    byte[] utf = new byte[length];
    in.get(utf);
    return new String(utf, StandardCharsets.UTF_8);
  }

  /** The new name of a type. */
  private static String type(String name) {
    int nested = name.indexOf('$');
    String outer = nested < 0 ? name : name.substring(0, nested);
    Optional<String> whole = RenamedNames.find(TYPES, name);
    return whole.orElseGet(
        () ->
            RenamedNames.find(TYPES, outer)
                .map(now -> now + name.substring(outer.length()))
                .orElse(name));
  }

  private void copy(int count) throws IOException {
    byte[] copied = new byte[count];
    in.get(copied);
    out.write(copied);
  }
}
