package org.dfra.river.identity;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.UnrecoverableKeyException;
import java.security.cert.Certificate;
import java.security.cert.X509Certificate;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * A key and its certificates, as an entry of a key store in PKCS #12.
 *
 * @param chain the certificate of the key, then those of its issuers
 */
public record KeyEntry(PrivateKey key, List<X509Certificate> chain) {

  /** Properties of the JDK's PKCS #12, whose default is 10 000. */
  private static final List<String> ITERATION_COUNTS =
      List.of(
          "keystore.pkcs12.keyPbeIterationCount",
          "keystore.pkcs12.certPbeIterationCount",
          "keystore.pkcs12.macIterationCount");

  /** The least that RFC 8018 section 4.2 recommends. */
  private static final String FEW_ITERATIONS = "1000";

  /** Copies the chain. */
  public KeyEntry {
    chain = List.copyOf(chain);
  }

  /** A robot's key with its certificate. */
  public static KeyEntry of(TeamCredentials.RobotKey robotKey) {
    return new KeyEntry(robotKey.key(), List.of(robotKey.certificate()));
  }

  /**
   * Reads an entry.
   *
   * @param bytes the key store
   * @param alias the entry's name
   * @param file the key store's name, for messages
   * @throws IdentityException if the bytes are no key store, the passphrase is wrong, or there is
   *     no such entry
   */
  public static KeyEntry read(byte[] bytes, char[] passphrase, String alias, String file)
      throws IdentityException {
    try {
      KeyStore store = KeyStore.getInstance("PKCS12");
      store.load(new ByteArrayInputStream(bytes), passphrase);
      List<X509Certificate> chain = new ArrayList<>();
      Certificate[] found = store.getCertificateChain(alias);
      for (Certificate each : found == null ? new Certificate[0] : found) {
        chain.add((X509Certificate) each);
      }
      if (!chain.isEmpty() && store.getKey(alias, passphrase) instanceof PrivateKey key) {
        return new KeyEntry(key, chain);
      }
    } catch (IOException e) {
      throw new IdentityException(
          e.getCause() instanceof UnrecoverableKeyException
              ? "the passphrase of " + file + " is wrong"
              : file + " is no key store in PKCS #12 (" + e.getMessage() + ")",
          e);
    } catch (GeneralSecurityException e) {
      throw new IdentityException(file + " cannot be opened (" + e + ")", e);
    }
    throw new IdentityException(file + " has no key named \"" + alias + "\"");
  }

  /**
   * The bytes of a key store in PKCS #12 with this entry alone.
   *
   * @param alias the entry's name
   * @param passphrase of the key store and the key
   */
  public byte[] toKeyStore(String alias, char[] passphrase) {
    try {
      KeyStore store = KeyStore.getInstance("PKCS12");
      store.load(null, null);
      store.setKeyEntry(alias, key, passphrase, chain.toArray(Certificate[]::new));
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      store.store(bytes, passphrase);
      return bytes.toByteArray();
    } catch (GeneralSecurityException | IOException e) {
      throw new IllegalStateException("every JDK writes PKCS #12 into memory", e);
    }
  }

  /**
   * The same for a passphrase that nobody can guess, so that nothing has to slow a search down.
   * Each process of a robot opens two such stores when it starts, which takes a tenth of a second
   * less.
   *
   * @param passphrase of at least 100 random bits
   */
  public byte[] toKeyStoreOfRandom(String alias, char[] passphrase) {
    synchronized (KeyEntry.class) { // the JDK takes these numbers from properties only
      Map<String, @Nullable String> before = new HashMap<>();
      for (String each : ITERATION_COUNTS) {
        before.put(each, System.getProperty(each));
        System.setProperty(each, FEW_ITERATIONS);
      }
      try {
        return toKeyStore(alias, passphrase);
      } finally {
        before.forEach(
            (name, value) -> {
              if (value == null) {
                System.clearProperty(name);
              } else {
                System.setProperty(name, value);
              }
            });
      }
    }
  }

  /** As a robot's key; its certificate is self-signed. */
  public TeamCredentials.RobotKey asRobotKey() {
    return new TeamCredentials.RobotKey(key, chain.get(0));
  }

  /** Names the certificate and no key. */
  @Override
  public String toString() {
    return chain.get(0).getSubjectX500Principal().getName();
  }
}
