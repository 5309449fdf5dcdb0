package org.dfra.river.loading;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLConnection;
import java.net.URLStreamHandler;
import java.security.CodeSource;
import java.security.SecureClassLoader;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import org.dfra.river.filter.TrustedLoader;
import org.dfra.river.loading.VerifiedJar.Content;
import org.jspecify.annotations.Nullable;

/**
 * Loads classes from verified jars. Classes of the parent come from the parent: the JDK, River and
 * the interfaces of dfra-api, so that both sides use the same types.
 */
final class VerifiedLoader extends SecureClassLoader implements TrustedLoader {

  static {
    ClassLoader.registerAsParallelCapable();
  }

  private final String codebase;
  private final List<String> digests;
  private final List<VerifiedJar> jars;

  /**
   * @param codebase the annotation of its classes when they are sent on
   * @param digests of the jars, in their order
   */
  VerifiedLoader(
      String codebase, List<String> digests, List<VerifiedJar> jars, ClassLoader parent) {
    super("downloaded", parent);
    this.codebase = codebase;
    this.digests = List.copyOf(digests);
    this.jars = List.copyOf(jars);
  }

  /** The annotation of its classes when they are sent on. */
  String codebase() {
    return codebase;
  }

  /** The digests of its jars, in their order. */
  List<String> digests() {
    return digests;
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    String path = name.replace('.', '/') + ".class";
    for (VerifiedJar jar : jars) {
      Content content = jar.content(path);
      if (content != null) {
        return define(name, content);
      }
    }
    throw missing(name);
  }

  /** The exception for a class that neither the parent nor a jar has. */
  ClassNotFoundException missing(String name) {
    return new ClassNotFoundException(
        name + " is neither on the class path nor in codebase " + codebase + "; serve its jar too");
  }

  @Override
  public boolean hasFile(String file) {
    for (VerifiedJar jar : jars) {
      if (jar.content(file) != null) {
        return true;
      }
    }
    return false;
  }

  private Class<?> define(String name, Content content) {
    int dot = name.lastIndexOf('.');
    if (dot > 0) {
      String packageName = name.substring(0, dot);
      if (getDefinedPackage(packageName) == null) {
        try {
          definePackage(packageName, null, null, null, null, null, null, null);
        } catch (IllegalArgumentException e) {
          // another thread was first
        }
      }
    }
    return defineClass(
        name, content.bytes(), 0, content.bytes().length, new CodeSource(null, content.signers()));
  }

  @Override
  protected @Nullable URL findResource(String name) {
    Enumeration<URL> found = findResources(name);
    return found.hasMoreElements() ? found.nextElement() : null;
  }

  @Override
  protected Enumeration<URL> findResources(String name) {
    List<URL> found = new ArrayList<>();
    for (int i = 0; i < jars.size(); i++) {
      Content content = jars.get(i).content(name);
      if (content != null) {
        found.add(url(digests.get(i), name, content.bytes()));
      }
    }
    return Collections.enumeration(found);
  }

  private static URL url(String digest, String name, byte[] bytes) {
    try {
      return new URL("dfra-code", digest, -1, "/" + name, new InMemoryHandler(bytes));
    } catch (MalformedURLException e) {
      throw new AssertionError("a URL with a handler of its own is always well-formed", e);
    }
  }

  @Override
  public String toString() {
    return "classes of " + codebase;
  }

  /** Opens a resource from memory. */
  private static final class InMemoryHandler extends URLStreamHandler {
    private final byte[] bytes;

    InMemoryHandler(byte[] bytes) {
      this.bytes = bytes;
    }

    @Override
    protected URLConnection openConnection(URL url) {
      return new URLConnection(url) {
        @Override
        public void connect() {
          connected = true;
        }

        @Override
        public long getContentLengthLong() {
          return bytes.length;
        }

        @Override
        public InputStream getInputStream() throws IOException {
          return new ByteArrayInputStream(bytes);
        }
      };
    }
  }
}
