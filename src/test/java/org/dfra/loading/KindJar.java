package org.dfra.loading;

import java.io.IOException;
import java.io.OutputStream;
import java.io.StringWriter;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import jdk.security.jarsigner.JarSigner;

/** A kind of module that is made while the test runs, so that it is on nobody's class path. */
final class KindJar {

  /** Password of the key stores, which live as long as the test. */
  static final String PASSWORD = "of-this-test";

  private static final String MARK =
      """
      static {
        String marker = System.getProperty("marker");
        if (marker != null) {
          try { new java.io.File(marker).createNewFile(); } catch (java.io.IOException e) { }
        }
      }
      """;

  private KindJar() {}

  /** The -dl jar of a laser scanner: interface, remote interface and proxy. */
  static Path lidar(Path folder, String version) throws IOException {
    return jar(
        folder,
        "lidar-dl.jar",
        Map.of(
            "sample.lidar.Lidar",
            """
            package sample.lidar;
            public interface Lidar extends org.dfra.module.Module {
              double[] scan() throws java.rmi.RemoteException;
            }
            """,
            "sample.lidar.RemoteLidar",
            """
            package sample.lidar;
            public interface RemoteLidar extends Lidar, org.dfra.river.remote.RemoteModule {}
            """,
            "sample.lidar.LidarProxy",
            """
            package sample.lidar;
            public final class LidarProxy extends org.dfra.river.proxy.ModuleProxy<Lidar>
                implements Lidar {
              %s
              public LidarProxy(org.dfra.river.remote.RemoteModule server, java.util.UUID id,
                  org.dfra.module.Identification identification) {
                super(Lidar.class, server, id, identification);
              }
              public double[] scan() throws java.rmi.RemoteException { return target().scan(); }
              public String build() { return "%s"; }
            }
            """
                .formatted(MARK, version)));
  }

  /** What a robot has of a laser scanner and its clients do not: server and driver. */
  static Path lidarServer(Path folder, Path kind) throws IOException {
    return jar(
        folder,
        "lidar.jar",
        List.of(kind),
        Map.of(
            "sample.lidar.LidarServer",
            """
            package sample.lidar;
            import java.rmi.MarshalledObject;
            import java.rmi.activation.ActivationID;
            import org.dfra.river.server.*;
            public final class LidarServer extends ModuleServer<Lidar> implements RemoteLidar {
              public LidarServer(ActivationID id, MarshalledObject<ModuleActivation> data)
                  throws Exception { super(Lidar.class, id, data); }
              public double[] scan() throws java.rmi.RemoteException { return module().scan(); }
            }
            """,
            "sample.lidar.LidarImpl",
            """
            package sample.lidar;
            public final class LidarImpl extends org.dfra.core.module.ModuleImpl implements Lidar {
              public LidarImpl(org.dfra.core.module.ModuleContext context) {
                super(context, "Laser scanner", "Test", "1");
              }
              protected void onStart() { transitionTo(org.dfra.lifecycle.Readiness.READY); }
              protected void onClose() {}
              public double[] scan() { return new double[] {1, 2, 3}; }
            }
            """));
  }

  /** A registrar's proxy that does harm as soon as it is initialised. */
  static Path registrar(Path folder) throws IOException {
    return jar(
        folder,
        "registrar-dl.jar",
        Map.of(
            "sample.evil.Registrar",
            """
            package sample.evil;
            import java.rmi.MarshalledObject;
            import net.jini.core.discovery.LookupLocator;
            import net.jini.core.event.*;
            import net.jini.core.lookup.*;
            public class Registrar implements ServiceRegistrar, java.io.Serializable {
              %s
              public ServiceRegistration register(ServiceItem i, long l) { return null; }
              public Object lookup(ServiceTemplate t) { return null; }
              public ServiceMatches lookup(ServiceTemplate t, int n) { return null; }
              public EventRegistration notify(ServiceTemplate t, int n, RemoteEventListener l,
                  MarshalledObject m, long d) { return null; }
              public Class[] getEntryClasses(ServiceTemplate t) { return null; }
              public Object[] getFieldValues(ServiceTemplate t, int i, String f) { return null; }
              public Class[] getServiceTypes(ServiceTemplate t, String p) { return null; }
              public ServiceID getServiceID() { return new ServiceID(1, 2); }
              public LookupLocator getLocator() { return null; }
              public String[] getGroups() { return new String[0]; }
            }
            """
                .formatted(MARK)));
  }

  private static Path jar(Path folder, String name, Map<String, String> sources)
      throws IOException {
    return jar(folder, name, List.of(), sources);
  }

  private static Path jar(Path folder, String name, List<Path> path, Map<String, String> sources)
      throws IOException {
    Path classes = Files.createTempDirectory(folder, "classes");
    StringWriter complaints = new StringWriter();
    boolean compiled =
        ToolProvider.getSystemJavaCompiler()
            .getTask(
                complaints,
                null,
                null,
                List.of(
                    "--release",
                    "17",
                    "-proc:none",
                    "-d",
                    classes.toString(),
                    "-cp",
                    Role.classPath(path)),
                null,
                sources.entrySet().stream()
                    .map(each -> source(each.getKey(), each.getValue()))
                    .toList())
            .call();
    if (!compiled) {
      throw new IOException("the test's code does not compile: " + complaints);
    }
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    Path jar = folder.resolve(name);
    try (OutputStream file = Files.newOutputStream(jar);
        JarOutputStream out = new JarOutputStream(file, manifest);
        Stream<Path> walk = Files.walk(classes)) {
      for (Path each : walk.filter(Files::isRegularFile).sorted().toList()) {
        out.putNextEntry(new ZipEntry(classes.relativize(each).toString()));
        Files.copy(each, out);
        out.closeEntry();
      }
    }
    return jar;
  }

  private static JavaFileObject source(String name, String text) {
    URI uri = URI.create("string:///" + name.replace('.', '/') + ".java");
    return new SimpleJavaFileObject(uri, JavaFileObject.Kind.SOURCE) {
      @Override
      public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return text;
      }
    };
  }

  /** Makes a key that is valid for a day. */
  static Path key(Path folder, String name) throws Exception {
    Path store = folder.resolve(name + ".p12");
    Process keytool =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "keytool").toString(),
                "-J-XX:TieredStopAtLevel=1",
                "-J-XX:+UseSerialGC",
                "-genkeypair",
                "-alias",
                name,
                "-keyalg",
                "EC",
                "-groupname",
                "secp256r1",
                "-dname",
                "CN=" + name,
                "-startdate",
                "-1M",
                "-validity",
                "1",
                "-storetype",
                "PKCS12",
                "-storepass",
                PASSWORD,
                "-keystore",
                store.toString())
            .redirectErrorStream(true)
            .start();
    String output = new String(keytool.getInputStream().readAllBytes());
    if (!keytool.waitFor(60, TimeUnit.SECONDS) || keytool.exitValue() != 0) {
      throw new IOException("keytool failed: " + output);
    }
    return store;
  }

  /** Signs a jar in place. */
  static Path sign(Path jar, Path store) throws Exception {
    KeyStore keys = KeyStore.getInstance(store.toFile(), PASSWORD.toCharArray());
    String alias = keys.aliases().nextElement();
    Certificate certificate = keys.getCertificate(alias);
    Path signed = jar.resolveSibling(jar.getFileName() + ".signed");
    try (ZipFile in = new ZipFile(jar.toFile());
        OutputStream out = Files.newOutputStream(signed)) {
      new JarSigner.Builder(
              (PrivateKey) keys.getKey(alias, PASSWORD.toCharArray()),
              CertificateFactory.getInstance("X.509").generateCertPath(List.of(certificate)))
          .build()
          .sign(in, out);
    }
    return Files.move(signed, jar, StandardCopyOption.REPLACE_EXISTING);
  }
}
