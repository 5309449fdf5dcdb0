package org.dfra.core.config;

/**
 * A configuration that cannot be used. Each line of the message names the place, the fault and the
 * remedy; for a file, there is a line for every fault in it.
 */
public final class ConfigurationException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  public ConfigurationException(String message) {
    super(message);
  }

  public ConfigurationException(String message, Throwable cause) {
    super(message, cause);
  }
}
