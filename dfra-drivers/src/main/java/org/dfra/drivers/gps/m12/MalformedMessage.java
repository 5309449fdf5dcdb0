package org.dfra.drivers.gps.m12;

/**
 * An intact frame with invalid content: its checksum is right, but a value is outside its valid
 * range.
 *
 * @param id the frame's two letters
 * @param reason which value, what it is, and which values are valid
 */
public record MalformedMessage(String id, String reason) implements M12Message {}
