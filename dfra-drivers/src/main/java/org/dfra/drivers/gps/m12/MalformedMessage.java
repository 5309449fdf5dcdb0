package org.dfra.drivers.gps.m12;

/**
 * An intact frame whose content cannot be: its checksum is right, but a value is outside what the
 * receiver can say.
 *
 * @param id the frame's two letters
 * @param reason which value, what it is and what it may be
 */
public record MalformedMessage(String id, String reason) implements M12Message {}
