package org.dfra.river.loading;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import java.util.Set;
import org.dfra.river.loading.CodeTrust.DownloadLimits;

/** Reads a {@link CodeTrust} from a properties file; paths in it are relative to the file. */
final class TrustFile {

  private static final String STORE = "trust.store";
  private static final String PASSWORD = "trust.store.password";
  private static final String FOLDER = "trust.certificates";
  private static final String PINNED = "pinned.";
  private static final String JAR_BYTES = "download.bytes";
  private static final String UNPACKED_BYTES = "download.unpacked.bytes";
  private static final String ENTRIES = "download.entries";
  private static final String MILLIS = "download.millis";
  private static final Set<String> KEYS =
      Set.of(STORE, PASSWORD, FOLDER, JAR_BYTES, UNPACKED_BYTES, ENTRIES, MILLIS);

  private final Path file;
  private final Properties properties = new Properties();

  TrustFile(Path file) {
    this.file = file.toAbsolutePath();
  }

  CodeTrust read() throws IOException {
    try (Reader reader = Files.newBufferedReader(file)) {
      properties.load(reader);
    } catch (IOException | IllegalArgumentException e) {
      throw new IOException(
          file + " cannot be read as a trust file (" + e + "); correct it, or -Ddfra.trust", e);
    }
    Set<X509Certificate> signers = new HashSet<>();
    Set<String> pinned = new HashSet<>();
    for (String key : properties.stringPropertyNames()) {
      if (key.startsWith(PINNED)) {
        pinned.add(digest(key));
      } else if (!KEYS.contains(key)) {
        throw fault(key, "is not a key of a trust file; use " + String.join(", ", sorted()));
      }
    }
    if (properties.containsKey(STORE)) {
      signers.addAll(store());
    }
    if (properties.containsKey(FOLDER)) {
      signers.addAll(folder());
    }
    DownloadLimits usual = DownloadLimits.DEFAULT;
    return new CodeTrust(
        signers,
        pinned,
        new DownloadLimits(
            number(JAR_BYTES, usual.jarBytes(), Integer.MAX_VALUE - 8),
            number(UNPACKED_BYTES, usual.unpackedBytes(), Integer.MAX_VALUE - 8),
            (int) number(ENTRIES, usual.entries(), 65_535),
            Duration.ofMillis(number(MILLIS, usual.timeout().toMillis(), 600_000))));
  }

  private static List<String> sorted() {
    List<String> keys = new ArrayList<>(KEYS);
    keys.add(PINNED + "NAME");
    Collections.sort(keys);
    return keys;
  }

  private String digest(String key) throws IOException {
    String digest = properties.getProperty(key).trim().toLowerCase(Locale.ROOT);
    if (!Digests.isSha256(digest)) {
      throw fault(key, "= \"" + digest + "\" is not a SHA-256; write its 64 hexadecimal digits");
    }
    return digest;
  }

  private Set<X509Certificate> store() throws IOException {
    Path path = beside(STORE);
    String password = properties.getProperty(PASSWORD);
    try {
      KeyStore store =
          KeyStore.getInstance(path.toFile(), password == null ? null : password.toCharArray());
      Set<X509Certificate> certificates = new HashSet<>();
      for (String alias : Collections.list(store.aliases())) {
        if (store.getCertificate(alias) instanceof X509Certificate certificate) {
          certificates.add(certificate);
        }
      }
      if (certificates.isEmpty()) {
        throw fault(STORE, "= " + path + " holds no certificate; import one with keytool");
      }
      return certificates;
    } catch (GeneralSecurityException | IOException | IllegalArgumentException e) {
      throw e instanceof TrustFault known
          ? known
          : fault(
              STORE, "= " + path + " cannot be opened (" + e + "); correct it or " + PASSWORD, e);
    }
  }

  private Set<X509Certificate> folder() throws IOException {
    Path path = beside(FOLDER);
    Set<X509Certificate> certificates = new HashSet<>();
    try (DirectoryStream<Path> files = Files.newDirectoryStream(path, "*.{pem,crt,cer}")) {
      for (Path each : files) {
        certificates.addAll(certificates(each));
      }
    } catch (IOException e) {
      throw e instanceof TrustFault known
          ? known
          : fault(FOLDER, "= " + path + " cannot be read (" + e + "); correct the path", e);
    }
    if (certificates.isEmpty()) {
      throw fault(FOLDER, "= " + path + " holds no *.pem, *.crt or *.cer; put certificates there");
    }
    return certificates;
  }

  private Set<X509Certificate> certificates(Path pem) throws IOException {
    Set<X509Certificate> certificates = new HashSet<>();
    try (InputStream in = Files.newInputStream(pem)) {
      for (Certificate each : CertificateFactory.getInstance("X.509").generateCertificates(in)) {
        certificates.add((X509Certificate) each);
      }
    } catch (GeneralSecurityException e) {
      throw fault(
          FOLDER, ": " + pem + " is not a certificate (" + e + "); replace or remove it", e);
    }
    return certificates;
  }

  private Path beside(String key) {
    return file.resolveSibling(properties.getProperty(key).trim());
  }

  private long number(String key, long otherwise, long most) throws IOException {
    String text = properties.getProperty(key);
    if (text == null) {
      return otherwise;
    }
    try {
      long number = Long.parseLong(text.trim());
      if (number >= 1 && number <= most) {
        return number;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw fault(key, "= \"" + text + "\" is not a whole number from 1 to " + most + "; correct it");
  }

  private TrustFault fault(String key, String what) {
    return new TrustFault(file + ": " + key + " " + what);
  }

  private TrustFault fault(String key, String what, Exception cause) {
    TrustFault fault = fault(key, what);
    fault.initCause(cause);
    return fault;
  }

  /** The message is complete. */
  private static final class TrustFault extends IOException {
    private static final long serialVersionUID = 1L;

    TrustFault(String message) {
      super(message);
    }
  }
}
